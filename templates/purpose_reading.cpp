#include "templates/purpose_reading.h"

#include <algorithm>
#include <cctype>

#include "core/text.h"
#include "templates/init_shape.h"
#include "templates/purposes.h"

namespace unietp {
namespace {

std::vector<std::string> purpose_names() {
  std::vector<std::string> names;
  for (const auto& kind : purpose_kinds()) names.emplace_back(kind.name);
  return names;
}

bool is_category(const Domain& domain, const std::string& name) {
  return domain.kind == Domain::Kind::Categories && domain.members.size() == 1 && !domain.members[0].slice &&
         domain.members[0].category == name;
}

/// Whether one of the literals of a start constraint says it.
bool says(const Formula& start, const Need& need) {
  const bool agent = need.thing == "agent";
  if (!is_category(start.domain, agent ? need.other : need.thing)) return false;
  const auto literals = start_literals(start);
  return std::any_of(literals.begin(), literals.end(), [&](const StartLiteral& literal) {
    if (literal.predicate != need.predicate || literal.positive != need.positive) return false;
    if (agent) return !literal.relation;
    return literal.relation ? is_category(literal.other, need.other) : literal.symbol == need.other;
  });
}

class PurposeReader {
 public:
  explicit PurposeReader(TemplateSource& source) : source_(source) {}

  std::vector<Error> read(const Sexpr& section) {
    const auto names = purpose_names();
    if (section.children.size() < 2 || !section.children[1].is_atom()) {
      error(section.pos,
            "expected a purpose, such as (purpose cleaning (because (dirty A))); accepted: " + join(names, ", "));
      return std::move(errors_);
    }
    const auto& word = section.children[1];
    if (purpose_kind(word.text) == nullptr) {
      const auto near = nearest_name(word.text, names);
      error(word.pos, "unknown purpose '" + word.text + "'; accepted: " + join(names, ", ") +
                          (near.empty() ? "" : "; did you mean '" + near + "'?"));
    }
    source_.value.purpose.name = word.text;
    for (std::size_t i = 2; i < section.children.size(); ++i) {
      const auto& part = section.children[i];
      if (!part.is_form("because") || i > 2) {
        error(part.pos, "expected at most one (because ...) after the purpose, such as (because (dirty A))");
        continue;
      }
      if (part.children.size() == 1) error(part.pos, "expected at least one reason, such as (because (dirty A))");
      for (std::size_t reason = 1; reason < part.children.size(); ++reason) read_need(part.children[reason]);
    }
    return std::move(errors_);
  }

 private:
  void error(SourcePos pos, std::string message) {
    errors_.push_back({Error::Kind::Parse, source_.value.file, pos, std::move(message)});
  }

  void read_need(const Sexpr& reason) {
    const bool negated = reason.is_form("not") && reason.children.size() == 2;
    const auto& literal = negated ? reason.children[1] : reason;
    const bool formed =
        literal.is_list() && (literal.children.size() == 2 || literal.children.size() == 3) &&
        std::all_of(literal.children.begin(), literal.children.end(), [](const Sexpr& c) { return c.is_atom(); });
    if (!formed) {
      error(reason.pos,
            "expected what a start constraint says of a placeholder, such as (dirty A) or (not (inside A B))");
      return;
    }
    const auto& word = literal.children[0];
    const auto predicate = predicate_named(word.text);
    if (!predicate) {
      std::vector<std::string> names;
      for (const auto& known : all_predicates()) names.emplace_back(known.name);
      const auto near = nearest_name(word.text, names);
      error(word.pos, "unknown predicate '" + word.text + "'" + (near.empty() ? "" : "; did you mean '" + near + "'?"));
      return;
    }
    const auto& items = literal.children;
    if (items.size() - 1 != info(*predicate).arguments.size()) {
      error(literal.pos, "'" + word.text + "' takes " + std::to_string(info(*predicate).arguments.size()) +
                             (info(*predicate).arguments.size() == 1 ? " placeholder" : " arguments"));
      return;
    }
    source_.value.purpose.needs.push_back(
        {!negated, *predicate, items[1].text, items.size() > 2 ? items[2].text : "", reason.pos});
  }

  TemplateSource& source_;
  std::vector<Error> errors_;
};

}  // namespace

std::vector<Error> read_purpose(const Sexpr& section, TemplateSource& source) {
  return PurposeReader(source).read(section);
}

std::vector<Error> check_purpose(const TemplateSource& source) {
  std::vector<Error> errors;
  const auto& value = source.value;
  // A start constraint that did not read may be the one.
  if (std::find(source.init_read.begin(), source.init_read.end(), false) != source.init_read.end()) return errors;
  for (const auto& need : value.purpose.needs) {
    const bool said = std::any_of(value.init.begin(), value.init.end(), [&](const Formula& start) {
      return !init_shape_problem(start) && says(start, need);
    });
    if (said) continue;
    errors.push_back({Error::Kind::Schema, value.file, need.pos,
                      "no start constraint says " + to_text(need) +
                          "; a reason repeats what init says of a placeholder, such as (dirty A) after (forall (?a - "
                          "A) (dirty ?a))"});
  }
  return errors;
}

std::string to_text(const Need& need) {
  std::string text = "(" + std::string(info(need.predicate).name) + " " + need.thing;
  if (!need.other.empty()) text += " " + need.other;
  text += ")";
  return need.positive ? text : "(not " + text + ")";
}

std::string need_in_words(const Need& need, const std::function<std::string(const std::string&)>& name_of) {
  auto word = replace_all(std::string(info(need.predicate).name), "_", " ");
  if (need.predicate == Predicate::InRoom) word = "in";
  if (need.predicate == Predicate::OnFloor) word = "on the floor of";
  if (need.predicate == Predicate::Nearest) word = "nearest to";
  std::string text = need.thing == "agent" ? "the agent" : name_of(need.thing);
  text += (need.positive ? " is " : " is not ") + word;
  if (need.other.empty()) return text;
  const bool with = need.predicate == Predicate::Filled || need.predicate == Predicate::Covered;
  const bool placeholder = std::isupper(static_cast<unsigned char>(need.other.front())) != 0;
  return text + (with ? " with " : " ") + (placeholder ? name_of(need.other) : need.other);
}

std::string to_text(const Purpose& purpose) {
  std::string text = purpose.name;
  if (purpose.needs.empty()) return text;
  text += " (because";
  for (const auto& need : purpose.needs) text += " " + to_text(need);
  return text + ")";
}

}  // namespace unietp
