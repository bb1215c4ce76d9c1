#include "akb/placement_rules.h"

#include "akb/row_reader.h"
#include "akb/table_words.h"
#include "akb/tables.h"
#include "core/files.h"

namespace unietp {

std::vector<PlacementRule> read_placement_rules(const std::filesystem::path& path, std::vector<Error>& errors) {
  std::vector<PlacementRule> rules;
  const auto text = read_file(path);
  if (!text) {
    errors.push_back(text.error());
    return rules;
  }
  RowReader row(path.string(), *text, {"kind", "relation", "receptacle", "weight"}, errors);
  for (const auto& cells : row.rows()) {
    row.at(cells);
    PlacementRule rule{row.required("kind"), row.one_of("relation", relation_names(), "relation"),
                       row.required("receptacle"), row.number("weight", 0, 100, false)};
    if (row.sound()) rules.push_back(std::move(rule));
  }
  return rules;
}

}  // namespace unietp
