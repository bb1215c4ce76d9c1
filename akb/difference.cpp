#include "akb/difference.h"

#include <algorithm>
#include <tuple>

namespace unietp {
namespace {

auto key(const Fact& fact) { return std::tie(fact.category, fact.name); }

std::vector<Fact> sorted_facts(const Knowledge& knowledge) {
  std::vector<Fact> all;
  for (const auto& category : knowledge.categories()) {
    auto facts = facts_of(knowledge, category);
    all.insert(all.end(), std::make_move_iterator(facts.begin()), std::make_move_iterator(facts.end()));
  }
  std::sort(all.begin(), all.end(), [](const Fact& a, const Fact& b) { return key(a) < key(b); });
  return all;
}

}  // namespace

std::vector<Difference> differences(const Knowledge& old, const Knowledge& now) {
  const auto before = sorted_facts(old), after = sorted_facts(now);
  std::vector<Difference> found;
  auto a = before.begin(), b = after.begin();
  while (a != before.end() || b != after.end()) {
    if (b == after.end() || (a != before.end() && key(*a) < key(*b))) {
      found.push_back({a->category, a->name, *a, std::nullopt});
      ++a;
    } else if (a == before.end() || key(*b) < key(*a)) {
      found.push_back({b->category, b->name, std::nullopt, *b});
      ++b;
    } else {
      if (!(*a == *b)) found.push_back({a->category, a->name, *a, *b});
      ++a;
      ++b;
    }
  }
  return found;
}

}  // namespace unietp
