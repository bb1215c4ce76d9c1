#include "sense/wants.h"

#include <algorithm>
#include <map>
#include <utility>

namespace unietp {
namespace {

/// What of a `:where` is looked at: the places and rooms of things, what they are near, and that they are dirty or
/// clean.
bool tells_of_the_start(Predicate predicate) {
  using enum Predicate;
  return predicate == On || predicate == Inside || predicate == InRoom || predicate == NextTo || predicate == Nearest ||
         predicate == Dirty || predicate == Clean;
}

/// Whether one of what the part binds is enough.
bool is_one(const Formula& part) {
  if (part.op != Formula::Op::Count) return part.op == Formula::Op::Exists;
  return part.number + (part.comparison == Comparison::Greater ? 1 : 0) <= 1;
}

class Collector {
 public:
  void read(const Formula& part, bool negated) {
    using enum Formula::Op;
    switch (part.op) {
      case Atom:
        atom(part, negated);
        break;
      case Not:
        read(part.children.front(), !negated);
        break;
      case Imply:
      case Until:  // what must hold before is only kept
        read(part.children.back(), negated);
        break;
      case And:
      case Or:
      case AtEnd:
      case Sometime:
      case Before:
        for (const auto& child : part.children) read(child, negated);
        break;
      case Forall:
      case Exists:
      case Number:
        bound(part, negated);
        break;
      case Count:
        count(part, negated);
        break;
      case CountCompare:
        compared(part, negated);
        break;
      case Equal:
      case Always:
        break;
    }
  }

  Wants wants;

 private:
  void bound(const Formula& part, bool negated) {
    const auto before = variables_;
    variables_[part.variable] = wants.things.size();
    wants.things.push_back(part.domain);
    wants.single.push_back(!negated && is_one(part));
    const bool outer = std::exchange(where_, true);
    for (const auto& where : part.domain.where) read(where, false);
    where_ = outer;
    for (const auto& child : part.children) read(child, negated);
    variables_ = before;
  }

  void count(const Formula& part, bool negated) {
    const bool some = part.comparison == Comparison::AtLeast || part.comparison == Comparison::Greater ||
                      (part.comparison == Comparison::Equal && part.number > 0);
    const bool none = part.number == 0 && !some;
    if (some || none) bound(part, negated != none);
  }

  void compared(const Formula& part, bool negated) {
    const bool first = part.comparison != Comparison::Less && part.comparison != Comparison::AtMost;
    const bool second = part.comparison != Comparison::Greater && part.comparison != Comparison::AtLeast;
    if (first) read(part.children.front(), negated);
    if (second) read(part.children.back(), negated);
  }

  std::optional<std::size_t> thing(const Term& term) const {
    const auto found = variables_.find(term.name);
    if (term.kind != Term::Kind::Variable || found == variables_.end()) return std::nullopt;
    return found->second;
  }

  void atom(const Formula& part, bool negated) {
    if (part.terms.empty()) return;
    if (part.terms.front().kind == Term::Kind::Agent) wants.moves_agent = wants.moves_agent || !negated;
    const auto first = thing(part.terms.front());
    if (!first) return;
    Want want{part.predicate, *first, std::nullopt, "", negated};
    if (part.terms.size() > 1) {
      want.other = thing(part.terms[1]);
      if (part.terms[1].kind == Term::Kind::Symbol) want.symbol = part.terms[1].name;
    }
    if (where_ && (negated || !tells_of_the_start(part.predicate))) return;
    auto& list = where_ ? wants.found : wants.wants;
    if (std::find(list.begin(), list.end(), want) == list.end()) list.push_back(want);
  }

  std::map<std::string, std::size_t> variables_;
  bool where_ = false;  // inside a `:where`
};

}  // namespace

Wants wants_of(const Formula& goal) {
  Collector collector;
  collector.read(goal, false);
  const auto all = collector.wants.wants;
  std::erase_if(collector.wants.wants, [&](const Want& on) {  // what is switched off again is not left on
    return on.predicate == Predicate::PowerOn && std::any_of(all.begin(), all.end(), [&](const Want& off) {
             return off.predicate == Predicate::PowerOff && off.thing == on.thing && off.negated == on.negated;
           });
  });
  return std::move(collector.wants);
}

}  // namespace unietp
