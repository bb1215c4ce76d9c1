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

std::map<std::string, Companions> count_companions(std::span<const Item> items, const Kinds& kinds) {
  struct Counted {
    std::map<Companions::Pair, int> pairs;
    int activities = 0;
  };
  std::map<std::string, Counted> counted;
  for (const auto& [activity, all] : kinds_of_activities(items, kinds)) {
    Counted& of_source = counted[activity.first];
    ++of_source.activities;
    for (auto a = all.begin(); a != all.end(); ++a) {
      for (auto b = a; b != all.end(); ++b) ++of_source.pairs[{*a, *b}];
    }
  }
  std::map<std::string, Companions> by_source;
  for (auto& [source, of_source] : counted)
    by_source.emplace(source, Companions(std::move(of_source.pairs), of_source.activities));
  return by_source;
}

Companions add_up(const std::map<std::string, Companions>& by_source) {
  std::map<Companions::Pair, int> pairs;
  int all = 0;
  for (const auto& [source, companions] : by_source) {
    for (const auto& [pair, count] : companions.activities()) pairs[pair] += count;
    all += companions.all();
  }
  return {std::move(pairs), all};
}

std::string csv_of(const std::map<std::string, Companions>& by_source, const Kinds& kinds) {
  std::string text = csv_line({"thing", "other", "activities", "source"});
  const auto& root = kinds.all().front().name;
  for (const auto& [source, companions] : by_source) {
    text += csv_line({root, root, std::to_string(companions.all()), source});
    for (const auto& [pair, count] : companions.activities())
      text += csv_line({pair.first, pair.second, std::to_string(count), source});
  }
  return text;
}

Companions read_companions(const std::filesystem::path& path, const Kinds& kinds, std::vector<Error>& errors) {
  const auto text = read_file(path);
  if (!text) {
    errors.push_back(text.error());
    return {};
  }
  RowReader row(path.string(), *text, {"thing", "other", "activities", "source"}, errors);
  std::map<Companions::Pair, int> pairs;
  std::set<std::pair<std::string, Companions::Pair>> seen;
  int all = 0;
  for (const auto& cells : row.rows()) {
    row.at(cells);
    const auto thing = row.required("thing"), other = row.required("other"), source = row.required("source");
    const int count = static_cast<int>(row.number("activities", 0, 1e6, false));
    for (const auto* column : {"thing", "other"}) {
      if (kinds.find(row.text(column)) == nullptr)
        row.fail(column, "'" + row.text(column) + "' is not a kind of kinds.csv");
    }
    if (other < thing) row.fail("other", "expected the two kinds in order");
    if (!seen.insert({source, {thing, other}}).second) {
      row.fail("other", "'" + thing + "' and '" + other + "' stand twice");
      continue;
    }
    const auto* kind = kinds.find(thing);
    const bool root = kind != nullptr && kind->parent.empty() && thing == other;
    (root ? all : pairs[{thing, other}]) += count;
  }
  return {std::move(pairs), all};
}

}  // namespace unietp
