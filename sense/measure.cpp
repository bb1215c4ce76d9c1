#include "sense/measure.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>

#include "core/digest.h"
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

}  // namespace

bool is_held_out(const Item& item) {
  const bool programs = item.evidence.source == "metadata:activity_programs.jsonl.gz";
  const bool placements = item.evidence.source == "metadata:procthor_receptacles.json";
  return !placements && hash_of("held out:" + item.evidence.source + ":" + item.group) % (programs ? 3 : 4) == 0;
}

std::vector<HeldOutFigures> measure_held_out(std::span<const Item> items, const Kinds& kinds,
                                             const CategoryKinds& categories, const Judgments& judgments,
                                             const std::vector<SenseRule>& rules, const Knowledge& physical) {
  std::vector<Item> fitted, held;
  for (const auto& item : items) (is_held_out(item) ? held : fitted).push_back(item);
  const CommonSense sense(kinds, categories, judgments, rules, add_up(fitted));
  const SwapPool pool(sense, physical);
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
    const auto draw = hash_of("swap:" + row.source + item.group + row.thing + row.role);
    if (const auto other = pool.swapped(row, SwapPool::By::Physics, draw)) {
      count(figures.moved, grade_of(sense, *other));
      figures.swapped.push_back({*other, grade_of(sense, *other)});
    }
    if (const auto other = pool.swapped(row, SwapPool::By::Listing, draw))
      count(figures.listed, grade_of(sense, *other));
  }
  std::vector<HeldOutFigures> all;
  for (auto& [source, figures] : by_source) all.push_back(std::move(figures));
  return all;
}

}  // namespace unietp
