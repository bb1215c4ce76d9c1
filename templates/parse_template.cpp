#include <algorithm>
#include <cctype>
#include <charconv>
#include <filesystem>
#include <map>
#include <set>
#include <utility>

#include "akb/knowledge.h"
#include "akb/rows.h"
#include "akb/table_words.h"
#include "core/plain_name.h"
#include "core/text.h"
#include "logic/formula_reading.h"
#include "templates/bracket_hint.h"
#include "templates/constraint_kinds.h"
#include "templates/idle_parts.h"
#include "templates/phrasing.h"
#include "templates/purpose_reading.h"
#include "templates/refinement_kinds.h"
#include "templates/sections.h"
#include "templates/template.h"
#include "templates/template_checks.h"

namespace unietp {
namespace {

std::vector<std::string> section_names(bool all) {
  std::vector<std::string> names;
  for (const auto& section : template_sections()) {
    if (all || !section.required) names.emplace_back(section.name);
  }
  return names;
}

const std::vector<std::string> kSectionNames = section_names(true);

bool is_template_name(std::string_view text) {
  return is_plain_name(text) && std::all_of(text.begin(), text.end(), [](char c) {
           return std::islower(static_cast<unsigned char>(c)) != 0 ||
                  std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '-';
         });
}

bool is_positive_number(std::string_view text) {
  int value = 0;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
  return failure == std::errc{} && end == text.data() + text.size() && value >= 1;
}

std::string hint(const std::string& name, const std::vector<std::string>& known) {
  const auto near = nearest_name(name, known);
  return near.empty() ? "" : "; did you mean '" + near + "'?";
}

class TemplateReader {
 public:
  TemplateReader(std::string_view file, std::string_view text) : file_(file), text_(text) { source_.value.file = file; }

  TemplateReading read() {
    auto expressions = read_sexprs(file_, text_);
    if (!expressions) {
      auto unread = expressions.error();
      unread.message += bracket_hint(text_);
      return {{}, {std::move(unread)}};
    }
    if (expressions->empty()) {
      error({1, 1}, "the file has no template; expected (template name (name \"...\") (split ...) ...)");
    } else {
      for (std::size_t i = 1; i < expressions->size(); ++i) {
        error((*expressions)[i].pos, "unexpected second expression; a file has exactly one template");
      }
      read_template(expressions->front());
    }
    std::stable_sort(errors_.begin(), errors_.end(), [](const Error& a, const Error& b) {
      return std::pair(a.pos.line, a.pos.column) < std::pair(b.pos.line, b.pos.column);
    });
    if (!errors_.empty()) return {{}, std::move(errors_)};
    return {{std::move(source_.value)}, {}};
  }

 private:
  void error(SourcePos pos, std::string message, Error::Kind kind = Error::Kind::Parse) {
    errors_.push_back({kind, file_, pos, std::move(message)});
  }
  void add(std::vector<Error> problems) {
    for (auto& problem : problems) errors_.push_back(std::move(problem));
  }
  void schema_error(SourcePos pos, std::string message) { error(pos, std::move(message), Error::Kind::Schema); }

  void read_template(const Sexpr& top) {
    if (!top.is_form("template")) {
      error(top.pos, "expected (template name (name \"...\") (split ...) ...)");
      return;
    }
    if (top.children.size() < 2 || !top.children[1].is_atom()) {
      error(top.pos, "expected the template's name after 'template', such as (template open-one ...)");
      return;
    }
    source_.name = top.children[1];
    source_.value.name = source_.name.text;
    check_name();
    std::map<SectionType, const Sexpr*> sections;
    for (std::size_t i = 2; i < top.children.size(); ++i) {
      const auto& child = top.children[i];
      if (!child.is_list() || child.children.empty() || !child.children[0].is_atom()) {
        error(child.pos, "expected a section, a bracketed list that starts with one of: " + join(kSectionNames, ", "));
        continue;
      }
      const auto& word = child.children[0].text;
      const auto* section = section_named(word);
      if (section == nullptr) {
        error(child.children[0].pos,
              "unknown section '" + word + "'; accepted: " + join(kSectionNames, ", ") + hint(word, kSectionNames));
        continue;
      }
      if (!sections.emplace(section->type, &child).second) error(child.pos, "duplicate section '" + word + "'");
    }
    for (const TemplateSection& section : template_sections()) {
      if (const auto found = sections.find(section.type); found != sections.end()) {
        read_section(section.type, *found->second);
      } else if (section.type == SectionType::Simulators) {
        source_.value.simulators.assign(kSimulators.begin(), kSimulators.end());
      } else if (section.required) {
        error(top.pos, "section '" + std::string(section.name) + "' is missing; only " +
                           join(section_names(false), ", ") + " are optional");
      }
    }
    add(check_template(source_));
    add(check_purpose(source_));
    add(idle_parts(source_));
  }

  void check_name() {
    const auto& name = source_.value.name;
    if (!is_template_name(name)) {
      error(source_.name.pos, "'" + name + "' is not a valid template name; accepted are a-z, 0-9 and '-'");
    }
    const auto stem = std::filesystem::path(file_).stem().string();
    if (stem != name) {
      schema_error(source_.name.pos,
                   "template '" + name + "' is in a file named '" + stem + "'; both names must be the same");
    }
  }

  void read_section(SectionType type, const Sexpr& section) {
    const std::vector<Sexpr> items(section.children.begin() + 1, section.children.end());
    switch (type) {
      case SectionType::Name:
        return read_title(section, items);
      case SectionType::Purpose:
        return add(read_purpose(section, source_));
      case SectionType::Split:
        return read_split(section, items);
      case SectionType::Refinement:
        return read_refinement(section, items);
      case SectionType::Simulators:
        return read_simulators(section, items);
      case SectionType::Parameters:
        return read_parameters(section, items);
      case SectionType::Constraints:
        return read_constraints(items);
      case SectionType::Init:
        return read_init(items);
      case SectionType::Goal:
        return read_goal(section, items);
      case SectionType::Instruction:
        return read_instructions(section, items);
    }
  }

  void read_title(const Sexpr& section, const std::vector<Sexpr>& items) {
    if (items.size() != 1 || items[0].kind != Sexpr::Kind::String) {
      error(section.pos, "expected one string, such as (name \"open one <A>\")");
      return;
    }
    source_.title = items[0];
    source_.value.title = items[0].text;
  }

  void read_split(const Sexpr& section, const std::vector<Sexpr>& items) {
    static const std::vector<std::string> kNames = {"atomic", "compositional", "logical"};
    if (items.size() != 1 || !items[0].is_atom()) {
      error(section.pos, "expected one word, such as (split atomic); accepted: " + join(kNames, ", "));
      return;
    }
    const auto split = split_named(items[0].text);
    if (!split) {
      error(items[0].pos,
            "unknown split '" + items[0].text + "'; accepted: " + join(kNames, ", ") + hint(items[0].text, kNames));
      return;
    }
    if (std::find(kNames.begin(), kNames.end(), items[0].text) == kNames.end()) {
      error(items[0].pos, "'" + items[0].text +
                              "' is the split of refined tasks; expected the class of the goal itself: " +
                              join(kNames, ", ") + "; use a section (refinement ...) for the refinement");
      return;
    }
    source_.value.split = *split;
    const auto folder = std::filesystem::path(file_).parent_path().filename().string();
    if (split_named(folder) && folder != items[0].text) {
      schema_error(items[0].pos, "a template of split '" + items[0].text + "' is in the folder '" + folder + "'");
    }
  }

  void read_refinement(const Sexpr& section, const std::vector<Sexpr>& items) {
    std::vector<std::string> names;
    for (const auto& kind : refinement_kinds()) names.emplace_back(kind.name);
    if (items.size() != 1 || !items[0].is_atom()) {
      error(section.pos, "expected one word, such as (refinement referring); accepted: " + join(names, ", "));
      return;
    }
    source_.refinement = items[0];
    source_.value.refinement = items[0].text;
    if (refinement_kind(items[0].text) != nullptr) return;
    error(items[0].pos,
          "unknown refinement '" + items[0].text + "'; accepted: " + join(names, ", ") + hint(items[0].text, names));
  }

  void read_simulators(const Sexpr& section, const std::vector<Sexpr>& items) {
    std::vector<std::string> names;
    for (const auto simulator : kSimulators) names.emplace_back(name_of(simulator));
    if (items.empty()) error(section.pos, "expected at least one simulator; accepted: " + join(names, ", "));
    for (const auto& item : items) {
      const auto simulator = item.is_atom() ? simulator_named(item.text) : std::nullopt;
      auto& list = source_.value.simulators;
      if (!simulator) {
        error(item.pos,
              "unknown simulator '" + item.text + "'; accepted: " + join(names, ", ") + hint(item.text, names));
      } else if (std::find(list.begin(), list.end(), *simulator) != list.end()) {
        error(item.pos, "simulator '" + item.text + "' is listed twice");
      } else {
        list.push_back(*simulator);
      }
    }
  }

  void read_parameters(const Sexpr& section, const std::vector<Sexpr>& items) {
    if (items.empty()) error(section.pos, "expected at least one parameter, such as (A - pickupable)");
    for (const auto& item : items) read_parameter(item);
  }

  void read_parameter(const Sexpr& item) {
    const bool formed =
        item.is_list() && item.children.size() >= 3 && item.children[1].is_atom("-") &&
        std::all_of(item.children.begin(), item.children.end(), [](const Sexpr& c) { return c.is_atom(); });
    if (!formed) {
      source_.parameters_read = false;
      error(item.pos,
            "expected a placeholder, '-' and its affordances, such as (A - pickupable) or (C - furniture "
            "container openable)");
      return;
    }
    Parameter parameter{item.children[0].text, {}, item.children[0].pos};
    if (!is_placeholder_name(parameter.name)) {
      source_.parameters_read = false;
      error(parameter.pos,
            "'" + parameter.name + "' is not a valid placeholder; it must start with a capital letter, such as A");
    }
    for (const auto& other : source_.value.parameters) {
      if (other.name == parameter.name) error(parameter.pos, "placeholder '" + parameter.name + "' is declared twice");
    }
    auto known = pseudo_affordances();
    known.insert(known.end(), affordance_names().begin(), affordance_names().end());
    for (std::size_t i = 2; i < item.children.size(); ++i) {
      const auto& word = item.children[i];
      if (std::find(known.begin(), known.end(), word.text) == known.end()) {
        error(word.pos,
              "unknown affordance '" + word.text + "'; accepted: " + join(known, ", ") + hint(word.text, known));
      }
      parameter.affordances.push_back(word.text);
    }
    using enum ParameterWord;
    for (const auto word : {Room, Color, Material, Substance}) {
      if (parameter.affordances.size() < 2 || !asks_for(parameter, word)) continue;
      const auto& alone = pseudo_affordances()[static_cast<std::size_t>(word)];
      schema_error(parameter.pos,
                   "a " + alone + " must be the only word; write (" + parameter.name + " - " + alone + ")");
    }
    source_.value.parameters.push_back(std::move(parameter));
  }

  void read_constraints(const std::vector<Sexpr>& items) {
    for (const auto& item : items) read_constraint(item);
  }

  void read_constraint(const Sexpr& item) {
    const auto before = errors_.size();
    read_sound_constraint(item);
    if (errors_.size() != before) source_.constraints_read = false;
  }

  void read_sound_constraint(const Sexpr& item) {
    const bool formed =
        item.is_list() && !item.children.empty() &&
        std::all_of(item.children.begin(), item.children.end(), [](const Sexpr& c) { return c.is_atom(); });
    if (!formed) {
      error(item.pos, "expected a constraint, such as (distinct A B) or (fits-on A B 2)");
      return;
    }
    const auto& word = item.children[0].text;
    const auto* kind = constraint_kind(word);
    if (kind == nullptr) {
      std::vector<std::string> names;
      for (const auto& known : constraint_kinds()) names.emplace_back(known.name);
      error(item.children[0].pos,
            "unknown constraint '" + word + "'; accepted: " + join(names, ", ") + hint(word, names));
      return;
    }
    DomainConstraint constraint{kind->type, {}, item.pos};
    for (std::size_t i = 1; i < item.children.size(); ++i) constraint.arguments.push_back(item.children[i].text);
    if (!has_right_arguments(*kind, constraint.arguments)) {
      error(item.pos, "wrong arguments; '" + word + "' is written " + std::string(kind->usage));
      return;
    }
    source_.value.constraints.push_back(std::move(constraint));
  }

  static bool has_right_arguments(const ConstraintKind& kind, const std::vector<std::string>& arguments) {
    using enum ConstraintKind::Meaning;
    std::size_t places = kind.meaning == Distinct ? arguments.size() : std::min<std::size_t>(2, arguments.size());
    if (kind.meaning == Words || kind.meaning == OfKind) places = std::min<std::size_t>(1, places);
    for (std::size_t i = 0; i < places; ++i) {
      const auto use = placeholder_use(arguments[i]);
      if (!is_placeholder_name(use.name)) return false;
    }
    if (kind.meaning == Sizes) return arguments.size() == 1;
    if (arguments.size() < 2) return false;
    if (kind.meaning == SameKind) {  // placeholders, then kinds
      const auto is_placeholder = [](const auto& word) { return is_placeholder_name(placeholder_use(word).name); };
      const auto kinds = std::find_if_not(arguments.begin(), arguments.end(), is_placeholder);
      return std::none_of(kinds, arguments.end(), is_placeholder) &&
             std::all_of(kinds, arguments.end(), [](const auto& word) { return is_plain_name(word); });
    }
    if (kind.meaning == Distinct) return true;
    if (kind.meaning == OfKind) {
      return std::all_of(arguments.begin() + 1, arguments.end(), [](const auto& word) { return is_plain_name(word); });
    }
    if (kind.meaning == Value || kind.meaning == Usual) return arguments.size() == 2;
    if (kind.meaning == Words) {
      return arguments.size() == 2 && alias_kind_named(arguments[1]).has_value();
    }
    if (kind.meaning == Placement)
      return arguments.size() == 2 || (arguments.size() == 3 && is_positive_number(arguments[2]));
    return arguments.size() == (kind.usage.find("substance") == std::string_view::npos ? 2U : 3U);
  }

  void read_init(const std::vector<Sexpr>& items) {
    for (const auto& item : items) {
      source_.init.push_back(item);
      auto reading = read_formula(file_, item, FormulaUse::State);
      source_.init_read.push_back(reading.formula.has_value());
      if (reading.formula) source_.value.init.push_back(std::move(*reading.formula));
      errors_.insert(errors_.end(), reading.errors.begin(), reading.errors.end());
    }
  }

  void read_goal(const Sexpr& section, const std::vector<Sexpr>& items) {
    if (items.size() != 1) {
      error(section.pos, "expected one formula; join several with (and ...)");
      return;
    }
    source_.goal.push_back(items[0]);
    auto reading = read_formula(file_, items[0], FormulaUse::Goal);
    source_.goal_read = reading.formula.has_value();
    if (reading.formula) source_.value.goal = std::move(*reading.formula);
    errors_.insert(errors_.end(), reading.errors.begin(), reading.errors.end());
  }

  void read_instructions(const Sexpr& section, const std::vector<Sexpr>& items) {
    if (items.empty())
      error(section.pos, "expected at least one phrasing, such as (instruction \"Open {A:indefinite}.\")");
    for (const auto& item : items) {
      if (item.kind != Sexpr::Kind::String) {
        error(item.pos, "expected a phrasing in double quotes");
        continue;
      }
      source_.phrasings.push_back(item);
      source_.value.instructions.push_back(item.text);
    }
  }

  std::string file_;
  std::string_view text_;
  TemplateSource source_;
  std::vector<Error> errors_;
};

}  // namespace

TemplateReading parse_template(std::string_view file, std::string_view text) {
  return TemplateReader(file, text).read();
}

}  // namespace unietp
