#include <algorithm>
#include <functional>
#include <map>

#include "akb/completed.h"
#include "akb/group_phrases.h"
#include "akb/kind_groups.h"
#include "akb/lexicon.h"
#include "akb/metadata_json.h"
#include "akb/placement_rules.h"
#include "akb/provenance.h"
#include "bodies.h"
#include "exports/bddl_words.h"
#include "exports/behavior_abilities.h"
#include "exports/virtualhome_unity.h"
#include "fuzz_bodies.h"
#include "grounding/home_census.h"
#include "interchange/format_facts.h"
#include "run/known_homes.h"
#include "support.h"

namespace unietp::fuzz {
namespace {

Tables two_things() {
  Tables tables;
  for (const char* name : {"Mug", "Table"}) {
    Category c;
    c.name = c.display = name;
    c.plural = c.display + "s";
    c.size = {0.1, 0.1, 0.1};
    c.mass = 0.3;
    tables.categories.push_back(std::move(c));
  }
  return tables;
}

using Errors = std::vector<Error>;

/// Appends the error of what is no list of errors.
template <class T>
void keep_error(const Result<T>& result, Errors& errors) {
  if (!result) errors.push_back(result.error());
}

/// Rows of a table that say something of a mug, whoever reads the table.
void look_up(const Folder& folder) {
  const Tables tables = two_things();
  for (const char* fact : {"size", "openable", "on:Table", "heats:Table", "alias:cup", "asset:Mug_1"}) {
    const auto name = parse_fact(fact);
    require(static_cast<bool>(name));
    for (const CuratedRow& row : curated_rows(folder.path(), Simulator::Ai2thor, tables.categories[0], *name))
      require(row.line >= 1);
  }
}

/// The tables about the simulators' scene files, one of which is given.
void read_scene_file_tables(const Folder& folder, Errors& errors) {
  const std::vector<std::pair<std::string, std::string>> sound{
      {"replicacad_words.csv", "word,category,source\nsofa,couch,curated\n"},
      {"procthor_doors.csv", "model,width_m,height_m,source\nDoorframe_1,1,2.1,curated\n"},
      {"procthor_floors.csv", "room,material,source\nBathroom,a,x\nBedroom,b,x\nKitchen,c,x\nLivingRoom,d,x\n"},
      {"virtualhome_rooms.csv", "class,room,source\nhallway,corridor,x\n"},
      {"virtualhome_states.csv", "word,state,source\nON,power_on,x\n"},
      {"virtualhome_properties.csv", "property,affordance,source\nGRABBABLE,pickupable,x\n"},
      {"virtualhome_prefabs.csv", "prefab,class,width_m,depth_m,height_m,source\nBed_1,bed,1,2,0.5,x\n"},
      {"virtualhome_faced.csv", "class,source\ntv,x\n"},
      {"building_words.csv", "word,source\nwall,x\n"},
      {"procthor_lacks.csv", "model,lacks,source\nMug_9,pickupable,x\n"}};
  for (const auto& [name, text] : sound) {
    if (!std::filesystem::exists(folder.path() / name)) folder.write(name, text);
  }
  const FormatFactsReading reading = read_format_facts(folder.path());
  errors = reading.errors;
  if (errors.empty()) require(door_model_for(0.9, reading.facts).width > 0);
}

/// Reads the file with this name in the folder.
const std::map<std::string, std::function<void(const Folder&, Errors&)>, std::less<>>& readers() {
  static const std::map<std::string, std::function<void(const Folder&, Errors&)>, std::less<>> all{
      {"kinds.csv",
       [](const Folder& folder, Errors& errors) { (void)read_kind_rooms(folder.path() / "kinds.csv", errors); }},
      {"lexicon.csv",
       [](const Folder& folder, Errors& errors) {
         folder.write("kinds.csv", "kind,rooms\ncup,kitchen\n");
         for (const auto& [display, word] : read_lexicon(folder.path(), errors))
           require(!display.empty() && !word.category.plural.empty() && word.category.size.minCoeff() > 0);
       }},
      {"kind_groups.csv",
       [](const Folder& folder, Errors& errors) { (void)read_kind_groups(folder.path() / "kind_groups.csv", errors); }},
      {"phrases.csv",
       [](const Folder& folder, Errors& errors) { (void)read_group_phrases(folder.path() / "phrases.csv", errors); }},
      {"placement_rules.csv",
       [](const Folder& folder, Errors& errors) {
         folder.write("placement_kinds.csv", "relation,receptacle,also,source\non,stove,oven,curated\n");
         for (const PlacementRule& rule : read_placement_rules(folder.path(), errors))
           require(!rule.receptacles.empty() && rule.weight > 0);
       }},
      {"placement_kinds.csv",
       [](const Folder& folder, Errors& errors) {
         folder.write("placement_rules.csv", "kind,relation,receptacle,weight\npot,on,stove,1\n");
         require(read_placement_rules(folder.path(), errors).size() <= 1);
       }},
      {"licences.csv",
       [](const Folder& folder, Errors& errors) {
         (void)license_of(read_licenses(folder.path() / "licences.csv", errors), "metadata:x");
       }},
      {"rules.csv",
       [](const Folder& folder, Errors& errors) {
         (void)meaning_of(read_rules(folder.path() / "rules.csv", errors), "derived:x");
       }},
      {"names.csv",
       [](const Folder& folder, Errors& errors) { keep_error(read_name_texts(folder.path() / "names.csv"), errors); }},
      {"structure.csv",
       [](const Folder& folder, Errors& errors) {
         keep_error(read_structure_names(folder.path() / "structure.csv"), errors);
       }},
      {"synsets.csv", [](const Folder& folder,
                         Errors& errors) { keep_error(read_bddl_synsets(folder.path() / "synsets.csv"), errors); }},
      {"substances.csv",
       [](const Folder& folder, Errors& errors) {
         keep_error(read_bddl_synsets(folder.path() / "substances.csv"), errors);
       }},
      {"abilities.csv",
       [](const Folder& folder, Errors& errors) {
         keep_error(read_behavior_abilities(folder.path() / "abilities.csv"), errors);
       }},
      {"virtualhome_unity.csv",
       [](const Folder& folder, Errors& errors) {
         keep_error(read_unity_properties(folder.path() / "virtualhome_unity.csv"), errors);
       }},
      {"benchmark-homes.csv",
       [](const Folder& folder, Errors& errors) { keep_error(read_known_homes(folder.path()), errors); }},
      {"replicacad_words.csv", read_scene_file_tables},
      {"procthor_doors.csv", read_scene_file_tables},
      {"procthor_floors.csv", read_scene_file_tables},
      {"virtualhome_rooms.csv", read_scene_file_tables},
      {"virtualhome_states.csv", read_scene_file_tables},
      {"virtualhome_properties.csv", read_scene_file_tables},
      {"virtualhome_prefabs.csv", read_scene_file_tables},
      {"virtualhome_faced.csv", read_scene_file_tables},
      {"building_words.csv", read_scene_file_tables},
      {"procthor_lacks.csv", read_scene_file_tables},
  };
  return all;
}

/// Facts that a language model once gave.
void read_facts(const Folder& folder, Errors& errors) {
  Tables tables = two_things();
  const CompletedFacts facts = read_completed(folder.path(), tables, errors);
  if (!errors.empty()) return;
  lay_under(facts, stated_by(tables), tables);
  for (const Category& c : tables.categories) require(c.size.minCoeff() > 0 && c.mass > 0);
}

}  // namespace

bool curated_body(std::string_view text) {
  static const Folder folder("curated");
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) std::filesystem::remove(entry.path());
  const std::size_t end = std::min(text.find('\n'), text.size());
  const std::string_view name = text.substr(0, end);
  const auto table = text.substr(std::min(end + 1, text.size()));
  Errors errors;
  if (const auto reader = readers().find(name); reader != readers().end()) {
    folder.write(name, table);
    reader->second(folder, errors);
  } else {
    constexpr std::string_view kCompleted = "completed/";
    static const std::vector<std::string> kTables{"size", "mass", "synset", "affordance", "relation", "alias"};
    const auto wanted = std::find_if(kTables.begin(), kTables.end(), [&](const std::string& one) {
      return name == std::string(kCompleted) + one + ".csv";
    });
    if (wanted == kTables.end()) return false;
    folder.write(*wanted + ".csv", table);
    read_facts(folder, errors);
  }
  look_up(folder);
  for (const Error& error : errors) check_error(error);
  return errors.empty();
}

}  // namespace unietp::fuzz
