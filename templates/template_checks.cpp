#include "templates/template_checks.h"

#include <algorithm>
#include <cctype>
#include <functional>
#include <set>

#include "core/limits.h"
#include "core/text.h"
#include "templates/constraint_kinds.h"
#include "templates/init_shape.h"
#include "templates/phrasing.h"
#include "templates/refinement_kinds.h"

namespace unietp {
namespace {

using Op = Formula::Op;

/// A place where a quantifier names its variable and domain: `(?x - D)` in `(forall (?x - D) f)`.
struct Binder {
  std::string quantifier;
  std::vector<const Sexpr*> names;  // the atoms that name categories
  SourcePos pos;
};

void names_in_domain(const Sexpr& domain, std::vector<const Sexpr*>& names) {
  if (domain.is_atom()) {
    names.push_back(&domain);
  } else if (domain.is_form("either")) {
    for (std::size_t i = 1; i < domain.children.size(); ++i) names_in_domain(domain.children[i], names);
  } else if (domain.is_list() && !domain.children.empty()) {  // (A :where f)
    names_in_domain(domain.children.front(), names);
  }
}

/// In the order of a walk from the top, as quantifiers_of walks the formula.
void collect_binders(const Sexpr& expression, const std::string& head, std::vector<Binder>& binders) {
  if (!expression.is_list()) return;
  if (is_binder(expression)) {
    Binder binder{head, {}, expression.pos};
    names_in_domain(expression.children[2], binder.names);
    binders.push_back(std::move(binder));
  }
  const auto own = !expression.children.empty() && expression.children[0].is_atom() ? expression.children[0].text : "";
  for (const auto& child : expression.children) collect_binders(child, own, binders);
}

std::vector<Binder> binders_of(const Sexpr& expression) {
  std::vector<Binder> binders;
  collect_binders(expression, "", binders);
  return binders;
}

/// A quantifier and those around it, outermost first.
struct Quantifier {
  const Formula* formula;
  std::vector<const Formula*> outer;
};

void collect_quantifiers(const Formula& formula, std::vector<const Formula*>& outer, std::vector<Quantifier>& found) {
  const bool binds = !formula.variable.empty();
  if (binds) {
    found.push_back({&formula, outer});
    outer.push_back(&formula);
    for (const auto& where : formula.domain.where) collect_quantifiers(where, outer, found);
  }
  for (const auto& child : formula.children) collect_quantifiers(child, outer, found);
  if (binds) outer.pop_back();
}

/// `(in_room ?a ?r)` as `(exists (?r - R) (in_room ?a ?r))`, where ?r is bound outside over a domain that `single` says
/// has one member; what speaks of no outer variable stays as it is.
Formula closed_over(const Formula& where, const std::vector<const Formula*>& outer,
                    const std::function<bool(const Domain&)>& single) {
  if (where.op == Op::And) {
    Formula all = where;
    for (auto& child : all.children) child = closed_over(child, outer, single);
    return all;
  }
  if (where.op != Op::Atom || where.terms.size() != 2 || where.terms[1].kind != Term::Kind::Variable) return where;
  for (const auto* binder : outer) {
    if (binder->variable == where.terms[1].name && single(binder->domain)) {
      return exists(binder->variable, binder->domain, where);
    }
  }
  return where;
}

/// The second arguments of these predicates.
std::vector<const Sexpr*> words_of(const Sexpr& expression, const std::vector<std::string_view>& predicates) {
  std::vector<const Sexpr*> words;
  if (!expression.is_list()) return words;
  for (const auto& child : expression.children) {
    for (const auto* word : words_of(child, predicates)) words.push_back(word);
  }
  const bool one = std::any_of(predicates.begin(), predicates.end(),
                               [&](std::string_view name) { return expression.is_form(name); });
  if (one && expression.children.size() == 3 && expression.children[2].is_atom()) {
    words.push_back(&expression.children[2]);
  }
  return words;
}

/// The placeholders for a color, material or substance: words that start with a capital letter.
std::vector<const Sexpr*> values_in(const Sexpr& expression) {
  auto words = words_of(expression, {"colour", "material", "covered", "filled"});
  std::erase_if(words, [](const Sexpr* word) {
    return word->text.empty() || std::isupper(static_cast<unsigned char>(word->text.front())) == 0;
  });
  return words;
}

bool is_fixed_domain(const std::string& name) { return name == "object" || name == "room" || name == "agent"; }

bool covers(const std::vector<StartLiteral>& has, const std::vector<StartLiteral>& wanted) {
  return std::all_of(wanted.begin(), wanted.end(),
                     [&](const StartLiteral& w) { return std::find(has.begin(), has.end(), w) != has.end(); });
}

bool names_category(const Domain& domain, const std::string& category) {
  return domain.kind == Domain::Kind::Categories && domain.members.size() == 1 && !domain.members[0].slice &&
         domain.members[0].category == category;
}

/// Whether `start` says that there is a `category` for which `wanted` holds.
bool guarantees(const Formula& start, const std::string& category, const std::vector<StartLiteral>& wanted) {
  if (demanded_count(start) < 1) return false;
  const auto literals = start_literals(start);
  if (names_category(start.domain, category) && covers(literals, wanted)) return true;
  return wanted.empty() && std::any_of(literals.begin(), literals.end(), [&](const StartLiteral& literal) {
           return literal.positive && literal.relation && names_category(literal.other, category);
         });
}

class Checker {
 public:
  explicit Checker(const TemplateSource& source) : source_(source), value_(source.value) {
    for (const auto& parameter : value_.parameters) declared_.push_back(parameter.name);
  }

  std::vector<Error> run() {
    check_placeholders();
    check_init_shapes();
    check_counts();
    check_never_vacuous();
    check_refinement();
    check_phrasings();
    check_title();
    return std::move(errors_);
  }

 private:
  void error(SourcePos pos, std::string message) {
    errors_.push_back({Error::Kind::Schema, value_.file, pos, std::move(message)});
  }

  bool is_declared(const std::string& name) const {
    return std::find(declared_.begin(), declared_.end(), name) != declared_.end();
  }

  void require_declared(const std::string& name, SourcePos pos) {
    if (is_declared(name) || !source_.parameters_read) return;
    const auto near = nearest_name(name, declared_);
    error(pos, "undeclared placeholder '" + name + "'; declared in parameters: " + join(declared_, ", ") +
                   (near.size() < 2 ? "" : "; did you mean '" + near + "'?"));  // of one letter any is near
  }

  void use_domains(const Sexpr& expression, std::set<std::string>& used) {
    for (const auto& binder : binders_of(expression)) {
      for (const auto* atom : binder.names) {
        if (is_fixed_domain(atom->text)) continue;
        const auto name = placeholder_use(atom->text).name;
        used.insert(name);
        require_declared(name, atom->pos);
        if (is_value_placeholder(name)) {
          error(atom->pos, "placeholder '" + name + "' is a word, not a category; write (colour ?x " + name +
                               "), (material ?x " + name + "), (covered ?x " + name + ") or (filled ?x " + name + ")");
        }
      }
    }
    use_values(expression, used);
  }

  bool is_value_placeholder(const std::string& name) const {
    return std::any_of(value_.parameters.begin(), value_.parameters.end(),
                       [&](const Parameter& parameter) { return parameter.name == name && is_value(parameter); });
  }

  void use_values(const Sexpr& expression, std::set<std::string>& used) {
    for (const auto* word : values_in(expression)) {
      used.insert(word->text);
      require_declared(word->text, word->pos);
      if (is_declared(word->text) && !is_value_placeholder(word->text)) {
        error(word->pos, "placeholder '" + word->text + "' stands for a category; declare (" + word->text +
                             " - colour), (" + word->text + " - material) or (" + word->text + " - substance)");
      }
    }
    for (const auto* word : words_of(expression, {"size"})) {
      if (word->text == "large" || word->text == "small") continue;
      error(word->pos, "unknown size '" + word->text + "'; accepted: large, small");
    }
  }

  void check_placeholders() {
    std::set<std::string> used;
    for (const auto& constraint : value_.constraints) {
      const auto meaning = info(constraint.type).meaning;
      for (const auto& use : placeholders_of(constraint)) {
        require_declared(use.name, constraint.pos);
        const bool compares =
            meaning == ConstraintKind::Meaning::Distinct || meaning == ConstraintKind::Meaning::SameKind;
        if (!compares) used.insert(use.name);
      }
    }
    for (const auto& expression : source_.init) use_domains(expression, used);
    for (const auto& expression : source_.goal) {
      use_domains(expression, used);
      for (const auto& binder : binders_of(expression)) {
        for (const auto* atom : binder.names) in_goal_.insert(placeholder_use(atom->text).name);
      }
      for (const auto* word : values_in(expression)) in_goal_.insert(word->text);
    }
    if (!source_.constraints_read || !source_.parameters_read) return;
    for (const auto& parameter : value_.parameters) {
      if (used.contains(parameter.name)) continue;
      error(parameter.pos, "placeholder '" + parameter.name +
                               "' is declared but never used; use it in the goal, init or a constraint other than "
                               "distinct, or remove it from parameters");
    }
  }

  void check_init_shapes() {
    std::size_t formula = 0;
    for (std::size_t i = 0; i < source_.init.size(); ++i) {
      if (!source_.init_read[i]) continue;
      const auto& start = value_.init[formula++];
      if (const auto problem = init_shape_problem(start)) {
        error(source_.init[i].pos, *problem);
      } else {
        starts_.push_back(&start);
      }
    }
  }

  /// Each start is drawn with as many objects as init asks for in all.
  void check_counts() {
    const auto most = limits::kCountedObjects;
    std::int64_t asked = 0;
    std::size_t formula = 0;
    for (std::size_t i = 0; i < source_.init.size(); ++i) {
      if (!source_.init_read[i]) continue;
      const auto before = asked;
      asked += demanded_count(value_.init[formula++]);
      if (before <= most && asked > most)
        error(source_.init[i].pos, "init asks for " + std::to_string(asked) + " objects up to here; at most " +
                                       std::to_string(most) + " are allowed");
    }
    if (!source_.goal_read) return;
    const auto binders = binders_of(source_.goal.front());
    std::vector<Quantifier> quantifiers;
    std::vector<const Formula*> outer;
    collect_quantifiers(value_.goal, outer, quantifiers);
    for (std::size_t i = 0; i < quantifiers.size() && i < binders.size(); ++i) {
      if (quantifiers[i].formula->op != Op::Count || quantifiers[i].formula->number <= most) continue;
      error(binders[i].pos, "this count compares with " + std::to_string(quantifiers[i].formula->number) +
                                "; at most " + std::to_string(most) + " is allowed");
    }
  }

  /// The start has exactly one object of the domain.
  bool has_one(const Domain& domain) const {
    return std::any_of(starts_.begin(), starts_.end(), [&](const Formula* start) {
      return start->op == Op::Count && start->comparison == Comparison::Equal && start->number == 1 &&
             start->domain == domain && start_literals(*start).empty();
    });
  }

  bool never_empty(const Quantifier& quantifier) const {
    const auto& domain = quantifier.formula->domain;
    const auto& variable = quantifier.formula->variable;
    if (domain.kind != Domain::Kind::Categories) return true;
    std::vector<StartLiteral> wanted;
    if (!domain.where.empty()) {
      const auto where =
          closed_over(domain.where.front(), quantifier.outer, [this](const Domain& d) { return has_one(d); });
      const auto condition = exists(variable, of_category("?"), where);
      if (init_shape_problem(condition)) return false;
      wanted = start_literals(condition);
    }
    return std::any_of(domain.members.begin(), domain.members.end(), [&](const Domain::Member& member) {
      return std::any_of(starts_.begin(), starts_.end(),
                         [&](const Formula* start) { return guarantees(*start, member.category, wanted); });
    });
  }

  void check_never_vacuous() {
    if (!source_.goal_read) return;
    const auto binders = binders_of(source_.goal.front());
    std::vector<Quantifier> quantifiers;
    std::vector<const Formula*> outer;
    collect_quantifiers(value_.goal, outer, quantifiers);
    for (std::size_t i = 0; i < quantifiers.size() && i < binders.size(); ++i) {
      const auto& quantifier = *quantifiers[i].formula;
      if (quantifier.op == Op::Exists || never_empty(quantifiers[i])) continue;
      const auto& domain = quantifier.domain;
      const auto name = domain.members.empty() ? "A" : domain.members.front().category;
      const auto body = domain.where.empty() ? "(and)" : to_text(domain.where.front());
      error(binders[i].pos, "this " + binders[i].quantifier +
                                " may have an empty domain: no init constraint guarantees that " + to_text(domain) +
                                " is not empty; add, for example, (count >= 1 (?" + quantifier.variable + " - " + name +
                                ") " + body + ") to init");
    }
  }

  /// A goal that is said to refer does, and one that gets its reference from the generator has none.
  void check_refinement() {
    const auto* kind = refinement_kind(value_.refinement);
    if (kind == nullptr || kind->split != Split::InstanceGrounding || !source_.goal_read || !source_.refinement) return;
    std::vector<const Formula*> outer;
    std::vector<Quantifier> quantifiers;
    collect_quantifiers(value_.goal, outer, quantifiers);
    const bool refers = std::any_of(quantifiers.begin(), quantifiers.end(), [](const Quantifier& quantifier) {
      return !quantifier.formula->domain.where.empty();
    });
    if (kind->written && !refers) {
      error(source_.refinement->pos,
            "the goal identifies no object: none of its domains has a ':where', such as (?a - (A :where (dirty ?a)))");
    } else if (!kind->written && refers) {
      error(source_.refinement->pos, "the goal has its own ':where'; write (refinement referring)");
    }
  }

  void check_phrasings() {
    for (std::size_t i = 0; i < source_.phrasings.size(); ++i) {
      const auto& phrasing = source_.phrasings[i];
      // A string stands in quotes, so its first byte is one column further.
      const auto at = [&](int offset) { return SourcePos{phrasing.pos.line, phrasing.pos.column + offset}; };
      const auto reading = read_slots(phrasing.text);
      for (const auto& bad : reading.errors) error(at(bad.pos.column), bad.message);
      std::set<std::string> said;
      for (const auto& slot : reading.slots) {
        said.insert(slot.placeholder);
        require_declared(slot.placeholder, at(static_cast<int>(slot.offset) + 1));
      }
      if (!reading.errors.empty()) continue;
      for (const auto& name : in_goal_) {
        if (!said.contains(name) && is_declared(name)) {
          error(phrasing.pos, "this phrasing does not mention {" + name + "}, which the goal uses");
        }
      }
    }
  }

  void check_title() {
    const std::string_view title = value_.title;
    for (std::size_t at = title.find('<'); at != std::string_view::npos; at = title.find('<', at + 1)) {
      const auto close = title.find('>', at);
      if (close == std::string_view::npos) break;
      require_declared(std::string(title.substr(at + 1, close - at - 1)),
                       {source_.title.pos.line, source_.title.pos.column + static_cast<int>(at) + 1});
    }
  }

  const TemplateSource& source_;
  const Template& value_;
  std::vector<std::string> declared_;
  std::set<std::string> in_goal_;
  std::vector<const Formula*> starts_;  // of value_.init: those of an enforceable shape
  std::vector<Error> errors_;
};

}  // namespace

bool is_binder(const Sexpr& expression) {
  return expression.is_list() && expression.children.size() >= 3 && expression.children[0].is_atom() &&
         expression.children[0].text.starts_with('?') && expression.children[1].is_atom("-");
}

std::vector<Error> check_template(const TemplateSource& source) { return Checker(source).run(); }

}  // namespace unietp
