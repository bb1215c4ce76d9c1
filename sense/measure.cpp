#include "sense/measure.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <set>

#include "core/digest.h"
#include "sense/companions.h"
#include "sense/fit.h"
#include "sense/swap_pool.h"

namespace unietp {
namespace {

std::uint64_t hash_of(const std::string& text) {
  const auto digest = sha256(text);
  std::uint64_t value = 0;
  std::from_chars(digest.data(), digest.data() + 15, value, 16);
  return value;
}

void count(GradeCounts& counts, Grade grade) { ++counts[static_cast<std::size_t>(grade)]; }

Grade grade_of(const CommonSense& sense, const Evidence& item) {
  return sense.grade({item.thing, item.thing, {}}, item.role).grade;
}

/// Grades items beside the other parts of their activities.
class CompanionGrader {
 public:
  CompanionGrader(const CommonSense& sense, std::span<const Item> fitted, std::span<const Item> held)
      : kinds_(sense.kinds()),
        companions_(add_up(count_companions(fitted, kinds_))),
        activities_(kinds_of_activities(held, kinds_)) {}

  bool knows(const Item& real) const { return activities_.contains({real.evidence.source, real.group}); }

  /// `item`: the real one, or another in its place.
  Grade graded(const Item& real, const Evidence& item, Grade alone) const {
    if (alone != Grade::Usual) return alone;
    const auto own = kinds_of(real.evidence, kinds_);
    auto others = activities_.at({real.evidence.source, real.group});
    for (const auto& kind : own) others.erase(kind);
    const bool swapped = item.thing != real.evidence.thing || item.role != real.evidence.role;
    for (const auto& kind : kinds_of(item, kinds_)) {
      if (swapped && own.contains(kind)) continue;
      const auto among = companions_.among(kind, others);
      if (among && *among < 1) return Grade::Tolerable;
    }
    return alone;
  }

 private:
  const Kinds& kinds_;
  Companions companions_;
  std::map<std::pair<std::string, std::string>, std::set<std::string>> activities_;
};

}  // namespace

bool is_held_out(const Item& item) {
  const bool programs = item.evidence.source == "metadata:activity_programs.jsonl.gz";
  const bool placements = item.evidence.source == "metadata:procthor_receptacles.json";
  return !placements && hash_of("held out:" + item.evidence.source + ":" + item.group) % (programs ? 3 : 4) == 0;
}

Judgments without_held_out(Judgments judgments, std::span<const Item> items) {
  for (const auto& item : items) {
    if (is_held_out(item)) judgments.erase({item.evidence.thing, item.evidence.role});
  }
  return judgments;
}

std::vector<HeldOutFigures> measure_held_out(std::span<const Item> items, const Kinds& kinds,
                                             const CategoryKinds& categories, const Judgments& judgments,
                                             const std::vector<SenseRule>& rules, const Knowledge& physical) {
  std::vector<Item> fitted, held;
  for (const auto& item : items) (is_held_out(item) ? held : fitted).push_back(item);
  const CommonSense sense(kinds, categories, judgments, rules, add_up(fitted));
  const SwapPool pool(sense, physical);
  const CompanionGrader beside(sense, fitted, held);
  std::map<std::string, HeldOutFigures> by_source;
  for (const auto& item : held) {
    const Evidence& row = item.evidence;
    if (family_of(row.role).ends_with('>')) continue;  // pairs are graded by their parts
    auto& figures = by_source[row.source];
    figures.source = row.source;
    const Grade grade = grade_of(sense, row);
    if (!item.counts) {
      count(figures.against, grade);
      continue;
    }
    count(figures.real, grade);
    figures.items.push_back({row, grade});
    if (beside.knows(item)) count(figures.real_beside, beside.graded(item, row, grade));
    const auto draw = hash_of("swap:" + row.source + item.group + row.thing + row.role);
    if (const auto other = pool.swapped(row, SwapPool::By::Physics, draw)) {
      const Grade moved = grade_of(sense, *other);
      count(figures.moved, moved);
      if (beside.knows(item)) count(figures.moved_beside, beside.graded(item, *other, moved));
      figures.swapped.push_back({*other, moved});
    }
    if (const auto other = pool.swapped(row, SwapPool::By::Listing, draw))
      count(figures.listed, grade_of(sense, *other));
  }
  std::vector<HeldOutFigures> all;
  for (auto& [source, figures] : by_source) all.push_back(std::move(figures));
  return all;
}

}  // namespace unietp
