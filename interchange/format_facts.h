#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "core/error.h"
#include "scene/geometry.h"
#include "scene/states.h"

namespace unietp {

/// A frame without a door that AI2-THOR puts into a gap in a wall. ProcTHOR's database of models has the type, which is
/// not among iTHOR's 125 and so not in the knowledge base.
struct DoorModel {
  std::string name;              // "Doorframe_1"
  double width = 0, height = 0;  // meters
};

/// A model of VirtualHome's that Unity places by its name.
struct Prefab {
  std::string name;          // "PRE_FUR_Kitchen_table_01_01"; "" for none
  Vec3 size = Vec3::Zero();  // width, depth, height in meters; zero where upstream tells none
};

/// VirtualHome's word for something, and ours.
template <class Ours>
struct FormatWord {
  std::string word;
  Ours ours{};
};

/// Facts about the simulators' scene files that neither the files nor the knowledge base hold. Source: the tables in
/// data/scene_files/, each row with its source.
struct FormatFacts {
  std::map<std::string, std::string, std::less<>> replicacad_words;  // of template names: "sofa" → category "couch"
  std::vector<DoorModel> door_models;                                // at least one
  std::map<std::string, std::string, std::less<>> floor_materials;   // each type of ProcTHOR's rooms → a material
  std::vector<FormatWord<std::string>> virtualhome_rooms = {};       // "livingroom" → room type "living_room"
  std::vector<FormatWord<Predicate>> virtualhome_states = {};        // "OPEN" → open
  std::vector<FormatWord<std::string>> virtualhome_properties = {};  // "GRABBABLE" → affordance "pickupable"
  std::set<std::string, std::less<>> virtualhome_faced = {};         // "tv": what is before it faces it
  std::set<std::string, std::less<>> building_words = {};            // "doorframe": letters and digits, lower case
  /// Of ProcTHOR's models the affordances of their categories that they lack: a mug that cannot be picked up.
  std::map<std::string, std::set<std::string>, std::less<>> model_lacks = {};
  /// The prefabs of each class of VirtualHome that the knowledge base has no models of.
  std::map<std::string, std::vector<Prefab>, std::less<>> virtualhome_prefabs = {};
};

/// The facts, of use only without errors.
struct FormatFactsReading {
  FormatFacts facts;
  std::vector<Error> errors;  // empty when sound
};
/// Reads replicacad_words.csv, procthor_doors.csv, procthor_floors.csv, virtualhome_rooms.csv, virtualhome_states.csv,
/// virtualhome_properties.csv, virtualhome_prefabs.csv, virtualhome_faced.csv, building_words.csv and
/// procthor_lacks.csv of a folder. Errors, all of them: Io; Parse and Schema with file, line and column: a column or a
/// row that is missing, a bad length, an unknown state or affordance, a name that stands twice.
FormatFactsReading read_format_facts(const std::filesystem::path& folder);

/// The frame nearest in width to a gap of `width_m`; ties go to the first.
const DoorModel& door_model_for(double width_m, const FormatFacts& facts);

}  // namespace unietp
