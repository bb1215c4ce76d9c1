#include "akb/placement_rules.h"

#include <map>
#include <utility>

#include "akb/row_reader.h"
#include "akb/table_words.h"

namespace unietp {

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
