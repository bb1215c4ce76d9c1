#include "exports/ltlf_formula.h"

#include <algorithm>

#include "logic/evaluate.h"

namespace unietp {
namespace {

using Op = Formula::Op;
using Texts = std::vector<std::string>;

constexpr std::size_t kLongestFormula = 100000;

constexpr const char* kTrue = "true";
constexpr const char* kFalse = "false";

std::string negated(const std::string& f) {
  if (f == kTrue) return kFalse;
  if (f == kFalse) return kTrue;
  return "!(" + f + ")";
}

/// `parts` joined by `sign`, without those that say nothing; `neutral` when there are none.
std::string joined(const Texts& parts, const char* sign, const std::string& neutral, const std::string& absorbing) {
  Texts kept;
  for (const auto& part : parts) {
    if (part == absorbing) return absorbing;
    if (part != neutral && std::find(kept.begin(), kept.end(), part) == kept.end()) kept.push_back(part);
  }
  if (kept.empty()) return neutral;
  if (kept.size() == 1) return kept.front();
  std::string text;
  for (const auto& part : kept) text += (text.empty() ? "(" : std::string(" ") + sign + " (") + part + ")";
  return text;
}
std::string all_of(const Texts& parts) { return joined(parts, "&", kTrue, kFalse); }
std::string any_of(const Texts& parts) { return joined(parts, "|", kFalse, kTrue); }

std::string name_part(const std::string& id) {
  std::string name;
  for (const char c : id) {
    const bool letter = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
    name += letter ? c : c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : '_';
  }
  return name;
}

class LtlfWriter {
 public:
  explicit LtlfWriter(const Trace& start) : start_(start) {
    for (std::size_t i = 0; i < start.entities.size(); ++i) {
      knows_later_ = knows_later_ || !start.states.front().exists(EntityIndex(i));
    }
  }

  Result<LtlfGoal> run(const Formula& goal) {
    LtlfGoal made{node(goal), {}};
    if (!why_.empty()) return Error{Error::Kind::Unsatisfiable, "", {}, why_};
    for (auto& [name, proposition] : propositions_) made.propositions.push_back(std::move(proposition));
    return made;
  }

 private:
  std::string refuse(const std::string& why) {
    if (why_.empty()) why_ = why;
    return kFalse;
  }

  std::string checked(std::string text) {
    return text.size() > kLongestFormula ? refuse("its formula would be longer than 100,000 characters")
                                         : std::move(text);
  }

  Texts nodes(const std::vector<Formula>& parts) {
    Texts texts;
    for (const auto& part : parts) texts.push_back(node(part));
    return texts;
  }

  std::string node(const Formula& f) {
    if (!why_.empty()) return kFalse;
    switch (f.op) {
      case Op::Atom:
        return atom(f);
      case Op::Equal:
        return entity_of(f.terms[0]) == entity_of(f.terms[1]) ? kTrue : kFalse;
      case Op::And:
        return checked(all_of(nodes(f.children)));
      case Op::Or:
        return checked(any_of(nodes(f.children)));
      case Op::Not:
        return negated(node(f.children[0]));
      case Op::Imply:
        return checked(any_of({negated(node(f.children[0])), node(f.children[1])}));
      case Op::Forall:
        return checked(all_of(instances(f)));
      case Op::Exists:
        return checked(any_of(instances(f)));
      case Op::Count:
        return count(instances(f), f.comparison, f.number);
      case Op::CountCompare:
        return compared(f);
      case Op::Number:
        break;
      case Op::AtEnd:
        return unary("G(F", node(f.children[0]), ")");
      case Op::Sometime:
        return unary("F", node(f.children[0]), "");
      case Op::Always:
        return unary("G", node(f.children[0]), "");
      case Op::Until:
        return checked(until(node(f.children[0]), node(f.children[1])));
      case Op::Before: {
        const std::string first = node(f.children[0]), second = node(f.children[1]), never = negated(second);
        return checked(all_of({until(never, all_of({first, never})), unary("F", second, "")}));
      }
    }
    return refuse("a number stands alone");
  }

  static std::string unary(const std::string& sign, const std::string& f, const char* end) {
    return f == kTrue || f == kFalse ? f : sign + "(" + f + ")" + end;
  }
  static std::string until(const std::string& f, const std::string& g) {
    return g == kTrue || g == kFalse ? g : "(" + f + ") U (" + g + ")";
  }

  /// The body for each object that the variable can stand for.
  Texts instances(const Formula& f) {
    if (f.domain.kind == Domain::Kind::Object) {
      refuse("it ranges over all objects, also those that come later");
      return {};
    }
    for (const auto& member : f.domain.members) {
      if (member.slice && !knows_later_) refuse("it ranges over pieces that do not exist at the start");
    }
    Texts bodies;
    for (const EntityIndex entity : members_of(f.domain, f.variable, start_, bound_)) {
      if (!why_.empty()) return {};
      bound_.emplace_back(f.variable, entity);
      bodies.push_back(once_there(entity, node(f.children[0]), f.op == Op::Forall));
      bound_.pop_back();
    }
    return bodies;
  }

  /// A body about something that exists, or comes to.
  std::string once_there(EntityIndex entity, const std::string& body, bool of_all) {
    if (start_.states.front().exists(entity)) return body;
    LtlfProposition there;
    there.presence = true;
    there.predicate = "exists";
    there.arguments = {start_.entities[entity].id};
    there.entities = {entity};
    const std::string comes = unary("F", proposition(std::move(there)), "");
    return of_all ? any_of({negated(comes), body}) : all_of({comes, body});
  }

  /// At least `n` of the formulas from position `at` on.
  std::string at_least(const Texts& formulas, std::size_t at, std::size_t n) {
    if (n == 0) return kTrue;
    if (!why_.empty()) return kFalse;
    if (formulas.size() - at < n) return kFalse;
    const std::string with = all_of({formulas[at], at_least(formulas, at + 1, n - 1)});
    return checked(any_of({with, at_least(formulas, at + 1, n)}));
  }

  std::string count(const Texts& formulas, Comparison comparison, int number) {
    const auto at_least_n = [&](int n) {
      return n <= 0 ? std::string(kTrue) : at_least(formulas, 0, static_cast<std::size_t>(n));
    };
    switch (comparison) {
      case Comparison::Equal:
        return all_of({at_least_n(number), negated(at_least_n(number + 1))});
      case Comparison::AtLeast:
        return at_least_n(number);
      case Comparison::AtMost:
        return negated(at_least_n(number + 1));
      case Comparison::Greater:
        return at_least_n(number + 1);
      case Comparison::Less:
        return negated(at_least_n(number));
    }
    return kFalse;
  }

  /// "number f > number g": for some n, f is n and n > number g.
  std::string compared(const Formula& f) {
    const Texts left = instances(f.children[0]), right = instances(f.children[1]);
    Texts cases;
    for (int n = 0; n <= static_cast<int>(left.size()) && why_.empty(); ++n) {
      const Comparison turned = f.comparison == Comparison::AtLeast   ? Comparison::AtMost
                                : f.comparison == Comparison::AtMost  ? Comparison::AtLeast
                                : f.comparison == Comparison::Greater ? Comparison::Less
                                : f.comparison == Comparison::Less    ? Comparison::Greater
                                                                      : Comparison::Equal;
      cases.push_back(all_of({count(left, Comparison::Equal, n), count(right, turned, n)}));
    }
    return checked(any_of(cases));
  }

  EntityIndex entity_of(const Term& term) const {
    if (term.kind == Term::Kind::Agent) {
      for (std::size_t i = 0; i < start_.entities.size(); ++i) {
        if (start_.entities[i].kind == Entity::Kind::Agent) return EntityIndex(i);
      }
    }
    const auto found =
        std::find_if(bound_.rbegin(), bound_.rend(), [&](const auto& one) { return one.first == term.name; });
    return found == bound_.rend() ? EntityIndex() : found->second;
  }

  std::string atom(const Formula& f) {
    LtlfProposition made;
    made.meaning = f.predicate;
    made.predicate = info(f.predicate).name;
    for (const auto& term : f.terms) {
      if (term.kind == Term::Kind::Symbol) {
        made.arguments.push_back(term.name);
      } else {
        made.entities.push_back(entity_of(term));
        made.arguments.push_back(start_.entities[made.entities.back()].id);
      }
    }
    return proposition(std::move(made));
  }

  /// The name of a proposition, which it gets here.
  std::string proposition(LtlfProposition made) {
    std::string name = name_part(made.predicate);
    for (const auto& argument : made.arguments) name += "_" + name_part(argument);
    for (int n = 2;; ++n) {  // two ids may differ only in signs that a name cannot have
      made.name = name;
      const auto [place, is_new] = propositions_.emplace(made.name, made);
      if (is_new || place->second.arguments == made.arguments) return made.name;
      name = name_part(made.predicate) + "_" + std::to_string(n);
      for (const auto& argument : made.arguments) name += "_" + name_part(argument);
    }
  }

  const Trace& start_;
  bool knows_later_ = false;  // what will come
  Assignment bound_;
  std::map<std::string, LtlfProposition> propositions_;
  std::string why_;  // the first reason
};

}  // namespace

bool LtlfProposition::holds_in(const Facts& facts) const {
  if (presence || !facts.exists(entities.front())) return facts.exists(entities.front());
  if (entities.size() == 2) return facts.exists(entities[1]) && facts.holds(meaning, entities[0], entities[1]);
  return arguments.size() == 2 ? facts.holds(meaning, entities[0], arguments[1]) : facts.holds(meaning, entities[0]);
}

Result<LtlfGoal> ltlf_goal(const Formula& goal, const Trace& start) { return LtlfWriter(start).run(goal); }

}  // namespace unietp
