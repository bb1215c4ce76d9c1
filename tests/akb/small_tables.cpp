#include "tests/akb/small_tables.h"

#include <algorithm>
#include <stdexcept>

#include <gtest/gtest.h>

#include "core/files.h"

namespace unietp::test {

std::map<std::string, std::string> small_tables() {
  const std::string end = ",curated,1,curated,1,curated,1\n";
  return {{"category",
           "name,display,plural,synset,countable,movable,archetype,width,depth,height,mass,rooms,colours,materials,"
           "source,confidence,size_source,size_confidence,mass_source,mass_confidence\n"
           "apple,apple,apples,apple.n.01,true,true,sphere,0.08,0.08,0.08,0.2,kitchen,red|green," +
               end + "fridge,fridge,fridges,,true,false,cabinet,0.75,0.72,1.8,75,kitchen,white,metal" + end +
               "half_apple,half apple,half apples,,true,true,box,0.08,0.08,0.04,0.1,kitchen,red," + end +
               "knife,knife,knives,knife.n.01,true,true,box,0.3,0.04,0.02,0.2,kitchen,grey,metal" + end +
               "mug,mug,mugs,mug.n.04,true,true,vessel,0.1,0.09,0.1,0.3,kitchen|office,white,ceramic" + end +
               "plate,plate,plates,plate.n.04,true,true,plate,0.24,0.24,0.02,0.5,kitchen,white,ceramic" + end},
          {"affordance",
           "category,affordance,source,confidence\n"
           "apple,pickupable,curated,1\n"
           "apple,sliceable,metadata:types.json,0.9\n"
           "fridge,container,curated,1\n"
           "fridge,openable,curated,1\n"
           "mug,pickupable,curated,1\n"},
          {"relation",
           "object,relation,receptacle,likelihood,capacity,source,confidence\n"
           "apple,inside,fridge,0.6,12,derived:kind,0.7\n"
           "apple,on,plate,0.4,3,llm:some-model,0.5\n"},
          {"effect",
           "tool,effect,target,gives,amount,needs,source,confidence\n"
           "fridge,cools,apple,,0,closed|inside,curated,1\n"
           "knife,slices,apple,half_apple,2,held,curated,1\n"},
          {"alias",
           "category,kind,text,source,confidence\n"
           "mug,function,something to drink from,curated,1\n"
           "mug,synonym,\"cup, with a handle\",curated,1\n"},
          {"asset",
           "asset,category,width,depth,height,source,confidence\n"
           "Mug_1,mug,0.11,0.09,0.1,metadata:assets.json,1\n"
           "Mug_2,mug,0.12,0.1,0.11,metadata:assets.json,1\n"}};
}

void write_small_tables(const std::filesystem::path& tables, const std::map<std::string, std::string>& texts) {
  for (const auto simulator : kSimulators) {
    for (const auto& [table, text] : texts) {
      const auto written = write_file(tables / std::string(name_of(simulator)) / (table + ".csv"), text);
      ASSERT_TRUE(written) << format(written.error());
    }
  }
}

Knowledge knowledge_of(Simulator simulator, Tables t) {
  return {simulator,
          std::move(t.categories),
          std::move(t.affordances),
          std::move(t.placements),
          std::move(t.effects),
          std::move(t.aliases),
          std::move(t.assets)};
}

Knowledge small_knowledge() {
  const ScratchFolder folder;
  write_small_tables(folder.path(), small_tables());
  std::vector<Error> errors;
  auto tables = read_tables(folder.path() / "ai2thor", errors);
  for (const auto& error : errors) ADD_FAILURE() << format(error);
  return knowledge_of(Simulator::Ai2thor, std::move(tables));
}

std::filesystem::path committed_tables() { return std::filesystem::path(UNIETP_SOURCE_DIR) / "data" / "akb"; }

Tables committed(Simulator simulator) {
  std::vector<Error> errors;
  auto tables = read_tables(committed_tables() / std::string(name_of(simulator)), errors);
  for (const auto& error : errors) ADD_FAILURE() << format(error);
  return tables;
}

const Category& category(const Tables& tables, const std::string& name) {
  const auto at = std::find_if(tables.categories.begin(), tables.categories.end(),
                               [&](const Category& c) { return c.name == name; });
  if (at == tables.categories.end()) throw std::out_of_range("no category " + name);
  return *at;
}

}  // namespace unietp::test
