#include "sense/companions.h"

#include <algorithm>

#include "akb/csv.h"
#include "akb/row_reader.h"
#include "core/files.h"

namespace unietp {
namespace {

constexpr double kUnseen = 0.3;     // activities that a kind is taken to occur in besides those counted
constexpr double kHalfOften = 0.5;  // of what chance gives

Companions::Pair pair_of(std::string_view a, std::string_view b) {
  return a <= b ? Companions::Pair(a, b) : Companions::Pair(b, a);
}

}  // namespace

int Companions::count(std::string_view a, std::string_view b) const {
  const auto found = activities_.find(pair_of(a, b));
  return found == activities_.end() ? 0 : found->second;
}

std::optional<double> Companions::among(std::string_view kind, const std::set<std::string>& others) const {
  if (others.empty()) return std::nullopt;
  const double share = (count(kind, kind) + kUnseen) / (all_ + 1);
  double sum = 0;
  for (const auto& other : others) sum += (count(kind, other) + share) / (count(other, other) + 1) / share;
  return sum / static_cast<double>(others.size());
}

bool Companions::strangers(std::string_view a, std::string_view b) const {
  if (all_ == 0 || a == b) return false;
  const double by_chance = static_cast<double>(count(a, a)) * count(b, b) / all_;
  return by_chance >= 1 && count(a, b) < kHalfOften * by_chance;
}

std::set<std::string> kinds_of(const Evidence& item, const Kinds& kinds) {
  std::set<std::string> all{item.thing};
  const auto mark = item.role.rfind(':');
  if (family_of(item.role) == "place" && mark != Role::npos) {
    if (auto place = item.role.substr(mark + 1); kinds.find(place) != nullptr) all.insert(std::move(place));
  }
  return all;
}

std::map<std::pair<std::string, std::string>, std::set<std::string>> kinds_of_activities(std::span<const Item> items,
                                                                                         const Kinds& kinds) {
  std::map<std::pair<std::string, std::string>, std::set<std::string>> activities;
  for (const auto& item : items) {
    const auto& source = item.evidence.source;
    const bool described = source == "metadata:activity_definitions" || source == "metadata:activity_programs.jsonl.gz";
    if (!described || !item.counts || family_of(item.evidence.role).ends_with('>')) continue;
    activities[{source, item.group}].merge(kinds_of(item.evidence, kinds));
  }
  return activities;
}

Companions count_companions(std::span<const Item> items, const Kinds& kinds) {
  std::map<Companions::Pair, int> pairs;
  const auto activities = kinds_of_activities(items, kinds);
  for (const auto& [activity, all] : activities) {
    for (auto a = all.begin(); a != all.end(); ++a) {
      for (auto b = a; b != all.end(); ++b) ++pairs[{*a, *b}];
    }
  }
  return {std::move(pairs), static_cast<int>(activities.size())};
}

std::string csv_of(const Companions& companions, const Kinds& kinds) {
  std::string text = csv_line({"thing", "other", "activities"});
  const auto& root = kinds.all().front().name;
  text += csv_line({root, root, std::to_string(companions.all())});
  for (const auto& [pair, count] : companions.activities())
    text += csv_line({pair.first, pair.second, std::to_string(count)});
  return text;
}

Companions read_companions(const std::filesystem::path& path, const Kinds& kinds, std::vector<Error>& errors) {
  const auto text = read_file(path);
  if (!text) {
    errors.push_back(text.error());
    return {};
  }
  RowReader row(path.string(), *text, {"thing", "other", "activities"}, errors);
  std::map<Companions::Pair, int> pairs;
  int all = 0;
  for (const auto& cells : row.rows()) {
    row.at(cells);
    const auto thing = row.required("thing"), other = row.required("other");
    const int count = static_cast<int>(row.number("activities", 0, 1e6, false));
    for (const auto* column : {"thing", "other"}) {
      if (kinds.find(row.text(column)) == nullptr)
        row.fail(column, "'" + row.text(column) + "' is not a kind of kinds.csv");
    }
    if (other < thing) row.fail("other", "expected the two kinds in order");
    const auto* kind = kinds.find(thing);
    if (kind != nullptr && kind->parent.empty() && thing == other) {
      all = count;
    } else if (!pairs.emplace(Companions::Pair(thing, other), count).second) {
      row.fail("other", "'" + thing + "' and '" + other + "' stand twice");
    }
  }
  return {std::move(pairs), all};
}

}  // namespace unietp
