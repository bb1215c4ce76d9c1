#include "sense/fit.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "akb/metadata_json.h"
#include "core/files.h"
#include "sense/category_kinds.h"
#include "sense/companions.h"

namespace unietp {

Result<std::vector<std::pair<std::string, std::string>>> read_category_synsets(const std::filesystem::path& bddl) {
  const auto table = read_metadata_csv(bddl / "synsets.csv");
  if (!table) return table.error();
  std::vector<std::pair<std::string, std::string>> synsets;
  for (const auto& row : table->rows) synsets.emplace_back(row[1].text, row[0].text);
  std::sort(synsets.begin(), synsets.end());
  return synsets;
}

Result<std::vector<Item>> read_items(const SenseSources& sources, const Vocabulary& vocabulary) {
  std::vector<Item> all;
  const auto& from = sources.metadata;
  for (auto part : {activity_items(sources.activities, vocabulary),
                    program_items(from / "virtualhome/activity_programs.jsonl.gz", vocabulary),
                    vote_items(from / "housekeep/preferences.csv.gz", vocabulary),
                    placement_items(from / "ai2thor/procthor_receptacles.json", vocabulary)}) {
    if (!part) return part.error();
    all.insert(all.end(), part->begin(), part->end());
  }
  return all;
}

std::vector<Evidence> add_up(std::span<const Item> items) {
  struct Sum {
    double weight = 0, heaviest = 0;
    std::string example;
  };
  std::map<std::tuple<std::string, Role, std::string>, Sum> sums;
  for (const auto& item : items) {
    if (!item.counts) continue;
    const auto& row = item.evidence;
    Sum& sum = sums[{row.thing, row.role, row.source}];
    sum.weight += row.weight;
    if (row.weight <= sum.heaviest) continue;
    sum.heaviest = row.weight;
    sum.example = row.example;
  }
  std::vector<Evidence> rows;
  for (const auto& [key, sum] : sums)
    rows.push_back({std::get<0>(key), std::get<1>(key), sum.weight, sum.example, std::get<2>(key)});
  return rows;
}

Result<Done> fit_sense_into(const std::filesystem::path& folder, const std::filesystem::path& tables,
                            const SenseSources& sources, const std::vector<Knowledge>& knowledge) {
  std::vector<Error> errors;
  const Kinds kinds = read_kinds(tables / "kinds.csv", errors);
  const WordKinds words = read_word_kinds(tables, kinds, errors);
  if (!errors.empty()) return errors.front();
  const auto net = Hypernyms::read(Hypernyms::kFolder);
  if (!net) return net.error();
  auto synsets = read_category_synsets(sources.bddl);
  if (!synsets) return synsets.error();
  const auto categories = find_category_kinds(knowledge, kinds, words, *net);
  if (!categories) return categories.error();
  const auto items = read_items(sources, {kinds, words, *net, std::move(*synsets)});
  if (!items) return items.error();
  const auto companions = count_companions(*items, kinds);
  for (const auto& [name, text] :
       {std::pair("categories.csv", csv_of(*categories)), std::pair("counts.csv", csv_of(add_up(*items))),
        std::pair("companions.csv", csv_of(companions, kinds))}) {
    if (const auto done = write_file(folder / name, text); !done) return done.error();
  }
  return Done{};
}

}  // namespace unietp
