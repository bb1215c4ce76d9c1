#include "akb/knowledge.h"
#include "akb/tables.h"
#include "bodies.h"
#include "fuzz_bodies.h"
#include "support.h"

namespace unietp::fuzz {
namespace {

constexpr std::string_view kBetween = "\n====\n";

}  // namespace

bool tables_body(std::string_view text) {
  static const Folder folder("tables");
  for (const std::string& table : table_names()) {
    const std::size_t end = text.find(kBetween);
    folder.write(table + ".csv", text.substr(0, end));
    text = end == std::string_view::npos ? "" : text.substr(end + kBetween.size());
  }
  std::vector<Error> errors;
  Tables tables = read_tables(folder.path(), errors);
  for (const Error& error : errors) check_error(error);
  if (!errors.empty()) return false;

  sort_tables(tables);
  std::vector<std::string> written;
  for (const std::string& table : table_names()) {
    written.push_back(table_csv(tables, table));
    folder.write(table + ".csv", written.back());
  }
  Tables again = read_tables(folder.path(), errors);
  require(errors.empty());
  sort_tables(again);
  for (std::size_t i = 0; i < written.size(); ++i) require(table_csv(again, table_names()[i]) == written[i]);

  const Knowledge knowledge(Simulator::Ai2thor, tables.categories, tables.affordances, tables.placements,
                            tables.effects, tables.aliases, tables.assets);
  for (const Category& category : tables.categories) require(knowledge.find(category.name) != nullptr);
  for (const AffordanceFact& fact : tables.affordances) require(knowledge.has(fact.category, fact.affordance));
  for (const Placement& p : tables.placements)
    require(knowledge.placement(p.object, p.relation, p.receptacle) != nullptr);
  for (const Effect& e : tables.effects) require(knowledge.effect(e.tool, e.treatment, e.target) != nullptr);
  return true;
}

}  // namespace unietp::fuzz
