#include "akb/placement_rules.h"

#include <map>
#include <utility>

#include "akb/row_reader.h"
#include "akb/table_words.h"
#include "core/files.h"

namespace unietp {
namespace {

/// Calls `read` for each row of a file. Errors are appended.
template <class Read>
void each_row(const std::filesystem::path& path, const std::vector<std::string>& columns, std::vector<Error>& errors,
              const Read& read) {
  const auto text = read_file(path);
  if (!text) {
    errors.push_back(text.error());
    return;
  }
  RowReader row(path.string(), *text, columns, errors);
  for (const auto& cells : row.rows()) {
    row.at(cells);
    read(row);
  }
}

}  // namespace

std::vector<PlacementRule> read_placement_rules(const std::filesystem::path& curated, std::vector<Error>& errors) {
  std::map<std::pair<Predicate, std::string>, std::vector<std::string>> also;  // by relation and receptacle
  each_row(curated / "placement_kinds.csv", {"relation", "receptacle", "also", "source"}, errors, [&](RowReader& row) {
    const auto relation = row.value_of("relation", relation_names(), "relation", placement_relation_named);
    auto& kinds = also[{relation, row.required("receptacle")}];
    kinds.push_back(row.required("also"));
  });
  std::vector<PlacementRule> rules;
  each_row(curated / "placement_rules.csv", {"kind", "relation", "receptacle", "weight"}, errors, [&](RowReader& row) {
    PlacementRule rule{row.required("kind"),
                       row.value_of("relation", relation_names(), "relation", placement_relation_named),
                       {row.required("receptacle")},
                       row.number("weight", 0, 100, false)};
    if (!row.sound()) return;
    const auto further = also.find({rule.relation, rule.receptacles.front()});
    if (further != also.end())
      rule.receptacles.insert(rule.receptacles.end(), further->second.begin(), further->second.end());
    rules.push_back(std::move(rule));
  });
  return rules;
}

}  // namespace unietp
