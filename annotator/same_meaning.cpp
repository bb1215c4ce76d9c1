#include <algorithm>
#include <utility>

#include "annotator/meaning.h"

namespace unietp {
namespace {

using Op = Formula::Op;

/// Left variables with the corresponding right variables.
using Pairing = std::vector<std::pair<std::string, std::string>>;

std::string partner_of(const Pairing& pairing, const std::string& name) {
  for (auto i = pairing.rbegin(); i != pairing.rend(); ++i)
    if (i->first == name) return i->second;
  return name;
}

bool match(const Formula& left, const Formula& right, Pairing& pairing);

bool match_terms(const std::vector<Term>& left, const std::vector<Term>& right, const Pairing& pairing) {
  if (left.size() != right.size()) return false;
  for (std::size_t i = 0; i < left.size(); ++i) {
    if (left[i].kind != right[i].kind) return false;
    const bool variable = left[i].kind == Term::Kind::Variable;
    if ((variable ? partner_of(pairing, left[i].name) : left[i].name) != right[i].name) return false;
  }
  return true;
}

bool match_domains(const Domain& left, const Domain& right, Pairing& pairing) {
  if (left.kind != right.kind || left.members != right.members || left.where.size() != right.where.size()) return false;
  return left.where.empty() || match(left.where[0], right.where[0], pairing);
}

/// Both are sequences without repeats, and for a fixed pairing `match` is an equivalence, so the first match is enough.
bool match_all(const std::vector<Formula>& left, const std::vector<Formula>& right, Pairing& pairing) {
  if (left.size() != right.size()) return false;
  std::vector<bool> taken(right.size(), false);
  for (const Formula& part : left) {
    bool found = false;
    for (std::size_t i = 0; i < right.size() && !found; ++i) {
      if (taken[i] || !match(part, right[i], pairing)) continue;
      taken[i] = found = true;
    }
    if (!found) return false;
  }
  return true;
}

using Binders = std::vector<const Formula*>;

Binders block(const Formula& f) {
  Binders binders{&f};
  while (binders.back()->children[0].op == f.op) binders.push_back(&binders.back()->children[0]);
  return binders;
}

/// Tries all pairings of the binders of two blocks, from `at` on.
bool match_blocks(const Binders& left, const Binders& right, std::size_t at, std::vector<bool>& taken,
                  Pairing& pairing) {
  if (at == left.size()) {
    for (const Formula* binder : left) {
      const std::string partner = partner_of(pairing, binder->variable);
      const auto other =
          std::find_if(right.begin(), right.end(), [&](const Formula* f) { return f->variable == partner; });
      if (!match_domains(binder->domain, (*other)->domain, pairing)) return false;
    }
    return match(left.back()->children[0], right.back()->children[0], pairing);
  }
  for (std::size_t i = 0; i < right.size(); ++i) {
    if (taken[i] || left[at]->domain.members != right[i]->domain.members) continue;
    taken[i] = true;
    pairing.emplace_back(left[at]->variable, right[i]->variable);
    const bool good = match_blocks(left, right, at + 1, taken, pairing);
    pairing.pop_back();
    taken[i] = false;
    if (good) return true;
  }
  return false;
}

bool match_bodies(const Formula& left, const Formula& right, Pairing& pairing) {
  pairing.emplace_back(left.variable, right.variable);
  const bool good =
      match_domains(left.domain, right.domain, pairing) && match(left.children[0], right.children[0], pairing);
  pairing.pop_back();
  return good;
}

bool match(const Formula& left, const Formula& right, Pairing& pairing) {
  if (left.op != right.op) return false;
  switch (left.op) {
    case Op::Atom:
      return left.predicate == right.predicate && match_terms(left.terms, right.terms, pairing);
    case Op::Equal: {
      std::vector<Term> turned(right.terms.rbegin(), right.terms.rend());
      return match_terms(left.terms, right.terms, pairing) || match_terms(left.terms, turned, pairing);
    }
    case Op::And:
    case Op::Or:
      return match_all(left.children, right.children, pairing);
    case Op::Forall:
    case Op::Exists: {
      const Binders a = block(left), b = block(right);
      std::vector<bool> taken(b.size(), false);
      return a.size() == b.size() && match_blocks(a, b, 0, taken, pairing);
    }
    case Op::Count:
      if (left.comparison != right.comparison || left.number != right.number) return false;
      return match_bodies(left, right, pairing);
    case Op::Number:
      return match_bodies(left, right, pairing);
    default:
      break;
  }
  if (left.children.size() != right.children.size() || left.comparison != right.comparison) return false;
  const auto in_order = [&](bool turned) {
    for (std::size_t i = 0; i < left.children.size(); ++i)
      if (!match(left.children[i], right.children[turned ? left.children.size() - 1 - i : i], pairing)) return false;
    return true;
  };
  const bool symmetric = left.op == Op::CountCompare && left.comparison == Comparison::Equal;
  return in_order(false) || (symmetric && in_order(true));
}

}  // namespace

bool same_meaning(const Formula& left, const Formula& right) { return same_expanded(expanded(left), expanded(right)); }

bool same_expanded(const Formula& left, const Formula& right) {
  Pairing pairing;
  return match(left, right, pairing);
}

}  // namespace unietp
