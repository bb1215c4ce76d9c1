#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "akb/knowledge.h"
#include "core/result.h"
#include "grounding/household.h"
#include "grounding/room_doors.h"

namespace unietp {

/// How many of a room type a home has, and how large they are; data/layouts/<simulator>_rooms.csv.
struct RoomRule {
  std::string type;
  double weight = 0;  // mean number in a home; only the proportions count
  int at_least = 0, at_most = 4;
  double area_low_m2 = 9, area_high_m2 = 20;
};

/// A piece of furniture in rooms of a type; data/layouts/<simulator>.csv.
struct FurnitureRule {
  std::string room;  // room type
  std::string category;
  double mean = 0;  // number in such a room
  int at_least = 0, at_most = 1;
  std::string where;  // as in grounding/furniture_position.h
};

/// A small thing in rooms of a type; data/layouts/<simulator>_objects.csv.
struct ObjectRule {
  std::string room;
  std::string category;
  double mean = 0;
};

/// How large the homes of a simulator are, those of the benchmark on average and those for training evenly;
/// data/layouts/home_scales.csv.
struct HomeScale {
  int fewest_rooms = 0, most_rooms = 0;
  double objects_a_room = 0;  // furniture and small things together
};

/// What a home of one simulator's style is made of.
struct LayoutRecipe {
  std::vector<RoomRule> rooms;
  std::vector<FurnitureRule> furniture;  // in the order in which a room is furnished; hosts before what needs them
  std::vector<ObjectRule> objects;
  double movable_share = 0.4;  // of a home's objects that are small things
  double unseen_share = 0;     // of small things that are of a category without a rule
  double floor_share = 0;      // of small things that lie on a floor
  RoomDoors doors;             // the same for all simulators
  HomeScale scale;
  std::map<std::string, double> held;          // receptacle category → mean number of things on or in one
  std::shared_ptr<const Household> household;  // nullptr: things are placed as the knowledge base says, mostly default
};

/// The four tables of one simulator as text.
struct RecipeTexts {
  std::string rooms, furniture, objects, receptacles;
};
/// Without doors, scale and household. Errors: Parse or Schema with file, line and column; the first.
Result<LayoutRecipe> read_recipe(const RecipeTexts& texts, const Knowledge& knowledge);
/// Reads home_scales.csv (simulator,fewest_rooms,most_rooms,objects_a_room,source). Errors are appended: Parse, Schema;
/// Schema for a simulator that stands twice or nowhere.
std::map<Simulator, HomeScale> read_home_scales(std::string_view where, std::string_view text,
                                                std::vector<Error>& errors);
/// The recipe with doors and scale, and with the household of the tables in `sense` beside the folder, which knows the
/// rules of small things. Errors: Io too.
Result<LayoutRecipe> load_recipe(const std::filesystem::path& folder, const Knowledge& knowledge);

}  // namespace unietp
