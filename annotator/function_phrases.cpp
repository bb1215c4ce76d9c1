#include "annotator/function_phrases.h"

#include <algorithm>

#include "generator/consistency.h"

namespace unietp {
namespace {

/// The categories of a domain that the goal or start ranges over become another domain.
Formula with_domain(Formula formula, const Domain& from, const Domain& to) {
  if (formula.domain.kind == from.kind && formula.domain.members == from.members) formula.domain.members = to.members;
  for (Formula& where : formula.domain.where) where = with_domain(where, from, to);
  for (Formula& child : formula.children) child = with_domain(child, from, to);
  return formula;
}

void collect_domains(const Formula& formula, std::vector<Domain>& into) {
  Domain bare = formula.domain;
  bare.where.clear();
  if (bare.kind == Domain::Kind::Categories && !bare.members.empty() && !bare.members[0].slice &&
      std::find(into.begin(), into.end(), bare) == into.end())
    into.push_back(bare);
  for (const Formula& child : formula.children) collect_domains(child, into);
}

/// Whether some object of the goal may be of several categories.
bool accepts_several(const Formula& goal) {
  return goal.domain.members.size() > 1 || std::any_of(goal.children.begin(), goal.children.end(), accepts_several);
}

bool holds_member(const Domain& domain, const Domain::Member& member) {
  return std::find(domain.members.begin(), domain.members.end(), member) != domain.members.end();
}

}  // namespace

std::optional<NounTable> narrowed_for(const Specification& specification, const Knowledge& knowledge,
                                      const NounTable& usual) {
  if (!names_by_phrase(specification.style) && !accepts_several(specification.goal)) return std::nullopt;
  NounTable nouns = usual;
  std::vector<Domain> domains;
  collect_domains(specification.goal, domains);
  const auto phrases = nouns.phrases();
  for (const auto& [phrase, meaning] : phrases) {
    const Domain& served = meaning.noun;
    for (const Domain& domain : domains) {
      bool means = std::all_of(domain.members.begin(), domain.members.end(),
                               [&all = served](const auto& member) { return holds_member(all, member); });
      for (const Domain::Member& member : served.members) {
        if (!means || holds_member(domain, member)) continue;
        Specification other = specification;
        const Domain alone = of_category(member.category);
        other.goal = with_domain(other.goal, domain, alone);
        for (Formula& start : other.init) start = with_domain(start, domain, alone);
        means = contradiction(other, knowledge).has_value();
      }
      if (!means) continue;
      nouns.narrow(phrase, domain);
      break;
    }
  }
  return nouns;
}

}  // namespace unietp
