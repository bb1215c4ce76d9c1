#include <set>

#include "akb/complete_answer.h"
#include "bodies.h"
#include "fuzz_bodies.h"
#include "llm/chat.h"
#include "support.h"

namespace unietp::fuzz {
namespace {

constexpr std::string_view kKey = "sk-fuzz-0123";

Category thing(const char* name, Archetype archetype, bool movable, const Vec3& size, double mass) {
  Category c;
  c.name = c.display = name;
  c.plural = c.display + "s";
  c.movable = movable;
  c.archetype = archetype;
  c.size = size;
  c.mass = mass;
  c.source = c.size_source = c.mass_source = {"derived:typical", 0.4};
  return c;
}

Tables kitchen() {
  Tables tables;
  tables.categories = {thing("fridge", Archetype::Cabinet, false, {0.75, 0.72, 1.8}, 75),
                       thing("mug", Archetype::Vessel, true, {0.1, 0.09, 0.1}, 0.3),
                       thing("table", Archetype::Table, false, {1.2, 0.8, 0.75}, 20)};
  tables.affordances = {{"fridge", "container", {"curated", 1}}, {"table", "receptacle", {"curated", 1}}};
  return tables;
}

std::size_t count_of(const CompletedFacts& f) {
  return f.sizes.size() + f.masses.size() + f.synsets.size() + f.affordances.size() + f.placements.size() +
         f.aliases.size();
}

}  // namespace

bool completion_body(std::string_view text) {
  static const Folder folder("completion");
  require(error_message_in(text, kKey).find(kKey) == std::string::npos);
  const auto read = read_completion(text, kKey);
  if (!read) {
    check_error(read.error());
    return false;
  }
  require(read->text.find(kKey) == std::string::npos);
  require(read->prompt_tokens >= 0 && read->completion_tokens >= 0);

  Tables tables = kitchen();
  const CompletionBatch batch{{"fridge", "mug", "table"}, {all_fact_kinds().begin(), all_fact_kinds().end()}};
  const auto checked = check_completion(read->text, tables, batch, {"llm:fuzz", 0.5}, nullptr);
  for (const auto& rejected : checked.rejected) require(!rejected.reason.empty() && rejected.value.size() < 80);

  // What was taken is sound: it is written, read back without a fault, and lies under the tables.
  require(static_cast<bool>(write_completed(folder.path(), checked.accepted)));
  std::vector<Error> errors;
  const auto again = read_completed(folder.path(), tables, errors);
  require(errors.empty() && count_of(again) == count_of(checked.accepted));
  lay_under(again, stated_by(tables), tables);
  for (const auto& c : tables.categories) require(c.size.minCoeff() > 0 && c.size.maxCoeff() <= 20 && c.mass > 0);
  std::set<std::pair<std::string, std::string>> seen;
  for (const auto& f : tables.affordances) require(seen.emplace(f.category, f.affordance).second);
  return true;
}

}  // namespace unietp::fuzz
