#include "expert/search_needs.h"

#include <algorithm>
#include <utility>

namespace unietp {
namespace {

using Op = Formula::Op;

std::vector<std::string> names_in(const Domain& domain) {
  std::vector<std::string> names;
  for (const Domain::Member& member : domain.members) names.push_back(member.category);
  return names;
}

/// Those of which the domain means the slices.
std::vector<std::string> cut_in(const Domain& domain) {
  std::vector<std::string> names;
  for (const Domain::Member& member : domain.members) {
    if (member.slice) names.push_back(member.category);
  }
  return names;
}

class NeedReader {
 public:
  SearchNeeds take() { return std::move(found_); }

  void read(const Formula& formula, bool wanted) {
    switch (formula.op) {
      case Op::Atom:
        return read_state(formula, wanted);
      case Op::Not:
        return read(formula.children[0], !wanted);
      case Op::Imply:
        read(formula.children[0], !wanted);
        return read(formula.children[1], wanted);
      case Op::Or:
        return read_choice(formula, wanted);
      case Op::Forall:
      case Op::Exists:
        return quantified(formula, wanted);
      case Op::Count:
      case Op::Number:
        return counted(formula);
      case Op::Before:
        read(formula.children[0], wanted);
        return read_in_order(formula.children[1], wanted);
      case Op::Always:
      case Op::Until:
        for (const Formula& part : formula.children) read_in_order(part, wanted);
        return;
      default:
        for (const Formula& part : formula.children) read(part, wanted);
    }
  }

 private:
  /// One branch will do, and which one is found last: none of them is waited for.
  void read_choice(const Formula& formula, bool wanted) {
    const std::size_t before = found_.needs.size();
    for (const Formula& part : formula.children) read(part, wanted);
    if (!wanted || formula.children.size() < 2) return;
    for (std::size_t i = before; i < found_.needs.size(); ++i) {
      if (!found_.needs[i].every) found_.needs[i].at_least = 0;
    }
  }

  /// What must not be so, or not yet.
  void read_in_order(const Formula& formula, bool wanted) {
    ++in_order_;
    read(formula, wanted);
    --in_order_;
  }

  const std::vector<std::string>* categories_of(const Term& term) const {
    if (term.kind != Term::Kind::Variable) return nullptr;
    for (auto bound = bound_.rbegin(); bound != bound_.rend(); ++bound) {
      if (bound->first == term.name) return &bound->second;
    }
    return nullptr;
  }

  void read_state(const Formula& atom, bool wanted) {
    const std::vector<std::string>* categories = atom.terms.empty() ? nullptr : categories_of(atom.terms[0]);
    if (categories == nullptr) return;
    if (in_order_ > 0 && (atom.predicate == Predicate::Open || atom.predicate == Predicate::Closed))
      found_.shut.insert(categories->begin(), categories->end());
    const bool relation = atom.terms.size() > 1 && atom.terms[1].kind != Term::Kind::Symbol;
    if (relation || atom.predicate == Predicate::Held) return;
    const std::string symbol = atom.terms.size() > 1 ? atom.terms[1].name : "";
    found_.states.push_back({*categories, {atom.predicate, symbol}, wanted, in_where_ > 0});
  }

  /// What a formula says that the variable is on, in, or in the room of.
  void note_places(const Formula& formula, const std::string& variable, SearchNeed& need) {
    if (formula.op == Op::Not) return;
    if (formula.op == Op::Exists) bound_.emplace_back(formula.variable, names_in(formula.domain));
    for (const Formula& part : formula.children) note_places(part, variable, need);
    if (formula.op == Op::Atom && formula.terms.size() == 2 && formula.terms[0].name == variable) {
      if (const auto* others = categories_of(formula.terms[1])) {
        auto& known = formula.predicate == Predicate::InRoom || formula.predicate == Predicate::OnFloor ? need.rooms
                                                                                                        : need.places;
        const bool at = formula.predicate == Predicate::On || formula.predicate == Predicate::Inside ||
                        formula.predicate == Predicate::NextTo || formula.predicate == Predicate::InRoom ||
                        formula.predicate == Predicate::OnFloor;
        if (formula.predicate == Predicate::Nearest) need.near.insert(need.near.end(), others->begin(), others->end());
        if (at) known.insert(known.end(), others->begin(), others->end());
        need.floor = need.floor || formula.predicate == Predicate::OnFloor;
      }
    }
    if (formula.op == Op::Exists) bound_.pop_back();
  }

  /// Slices that nobody has cut yet ask for something to cut with.
  void note_cutting(const Domain& domain) {
    if (auto whole = cut_in(domain); !whole.empty())
      found_.states.push_back({std::move(whole), {Predicate::Sliced, ""}, true, false});
  }

  static bool compares(const Formula& formula) {
    if (formula.op == Op::Atom) return formula.predicate == Predicate::Nearest || formula.predicate == Predicate::Size;
    return std::any_of(formula.children.begin(), formula.children.end(), compares);
  }

  void quantified(const Formula& formula, bool wanted) {
    SearchNeed need{names_in(formula.domain)};
    const bool one = (formula.op == Op::Exists) == wanted;
    need.every = !one;
    if (one) note_cutting(formula.domain);
    bound_.emplace_back(formula.variable, need.categories);
    for (const Formula& where : formula.domain.where) {
      note_places(where, formula.variable, need);
      need.every = need.every || compares(where);
      ++in_where_;
      read(where, true);
      --in_where_;
    }
    if (formula.op == Op::Exists && !wanted) {
      need.at_least = 0;
      note_places(formula.children[0], formula.variable, need);
    }
    const Formula& child = formula.children[0];
    const Formula& body = child.op == Op::AtEnd ? child.children[0] : child;
    if (formula.op == Op::Forall && wanted && body.op == Op::Not) {  // none of them may be there
      need.at_least = 0;
      note_places(body.children[0], formula.variable, need);
    }
    found_.needs.push_back(std::move(need));
    read(formula.children[0], wanted);
    bound_.pop_back();
  }

  void counted(const Formula& formula) {
    const auto categories = names_in(formula.domain);
    bound_.emplace_back(formula.variable, categories);
    SearchNeed there{categories, 0, true};
    note_places(formula.children[0], formula.variable, there);
    const bool lower_bound = formula.op == Op::Count &&
                             (formula.comparison == Comparison::AtLeast || formula.comparison == Comparison::Greater);
    const bool of_hand = formula.children[0].op == Op::Atom && formula.children[0].predicate == Predicate::Held;
    const bool counts_up = formula.comparison == Comparison::Equal || lower_bound;
    int wanted = counts_up ? formula.number : 0;
    if (formula.comparison == Comparison::Greater) ++wanted;
    if (formula.op == Op::Number) wanted = 1;
    if (!lower_bound && !of_hand) found_.needs.push_back(std::move(there));
    if (wanted > 0) found_.needs.push_back({categories, wanted});
    if (wanted > 0) note_cutting(formula.domain);
    read(formula.children[0], wanted > 0);
    bound_.pop_back();
  }

  SearchNeeds found_;
  std::vector<std::pair<std::string, std::vector<std::string>>> bound_;
  int in_order_ = 0, in_where_ = 0;
};

}  // namespace

bool holds(const std::vector<std::string>& list, const std::string& one) {
  return std::find(list.begin(), list.end(), one) != list.end();
}

SearchNeeds search_needs(const Formula& goal) {
  NeedReader reader;
  reader.read(goal, true);
  return reader.take();
}

}  // namespace unietp
