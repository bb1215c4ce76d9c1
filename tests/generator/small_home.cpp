#include "small_home.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>
#include <stdexcept>

#include "core/text.h"
#include "logic/evaluate.h"

namespace unietp {
namespace {

const Source kCurated = {"curated", 1};

// As data/sense/kinds.csv has them, narrowest first.
const std::map<std::string, std::vector<std::string>> kKinds = {
    {"Apple", {"fruit", "produce", "food", "movable"}},
    {"AppleSliced", {"fruit_piece", "fruit", "produce", "food", "movable"}},
    {"Book", {"book", "movable"}},
    {"Bowl", {"bowl", "tableware", "movable"}},
    {"Bread", {"bread", "ready_food", "food", "movable"}},
    {"BreadSliced", {"bread", "ready_food", "food", "movable"}},
    {"Cabinet", {"kitchen_cabinet", "cabinet", "place"}},
    {"Counter", {"counter", "place"}},
    {"Drawer", {"drawer", "place"}},
    {"Fridge", {"fridge", "place"}},
    {"Knife", {"cutlery", "tableware", "movable"}},
    {"Lamp", {"room_lamp", "fixture"}},
    {"Microwave", {"microwave", "place"}},
    {"Mug", {"cup", "tableware", "movable"}},
    {"Plate", {"plate", "tableware", "movable"}},
    {"Pot", {"pot", "cookware", "movable"}},
    {"Shelf", {"shelf", "place"}},
    {"Sink", {"sink", "place"}},
    {"Table", {"dining_table", "place"}},
    {"Television", {"television", "fixture"}}};
// As data/sense/kind_traits.csv gives them to these kinds.
const std::map<std::string, std::vector<KindTrait>> kTraits = {
    {"Cabinet", {KindTrait::PutsAway}},
    {"Drawer", {KindTrait::PutsAway}},
    {"Knife", {KindTrait::OneSize, KindTrait::Dish}},
    {"Lamp", {KindTrait::SeenRunning, KindTrait::GivesLight}},
    {"Microwave", {KindTrait::SeenRunning}},
    {"Sink", {KindTrait::ToldByRoom}},
    {"Television", {KindTrait::SeenRunning, KindTrait::GivesLight}}};

Category category(const std::string& name, bool movable) {
  Category made;
  made.name = name;
  made.display = lower(name);
  made.plural = made.display + "s";
  made.movable = movable;
  made.size = Vec3(0.2, 0.2, 0.2);
  made.mass = 1;
  made.rooms = {"Kitchen"};
  if (!movable) made.rooms.push_back("LivingRoom");
  made.source = made.size_source = made.mass_source = kCurated;
  return made;
}

}  // namespace

Knowledge small_home(Simulator simulator) {
  const std::vector<std::string> movable = {"Apple",       "AppleSliced", "Book", "Bowl",  "Bread",
                                            "BreadSliced", "Knife",       "Mug",  "Plate", "Pot"};
  const std::vector<std::string> furniture = {"Cabinet",   "Counter", "Drawer", "Fridge", "Lamp",
                                              "Microwave", "Shelf",   "Sink",   "Table",  "Television"};
  std::vector<Category> categories;
  std::vector<AffordanceFact> affordances;
  const auto afford = [&](const std::string& name, const std::vector<std::string>& words) {
    for (const auto& word : words) affordances.push_back({name, word, kCurated});
  };
  for (const auto& name : movable) {
    categories.push_back(category(name, true));
    afford(name, {"pickupable"});
  }
  for (const auto& name : furniture) categories.push_back(category(name, false));
  for (auto& known : categories) {
    known.kinds = kKinds.at(known.name);
    known.kinds.push_back("thing");
    if (const auto traits = kTraits.find(known.name); traits != kTraits.end()) known.traits = traits->second;
    if (known.name == "Mug" || known.name == "Book") known.colors = {"blue", "orange", "red"};
    if (known.name == "Table" || known.name == "Shelf") known.materials = {"glass", "wood"};
  }
  for (const auto* name : {"Bowl", "Mug", "Plate", "Pot"}) afford(name, {"dirtyable", "heatable"});
  for (const auto* name : {"Apple", "Bread"}) afford(name, {"sliceable", "heatable", "cookable"});
  for (const auto* name : {"Cabinet", "Drawer", "Fridge", "Microwave"}) afford(name, {"container", "openable"});
  for (const auto* name : {"Counter", "Shelf", "Table"}) afford(name, {"receptacle"});
  for (const auto* name : {"Lamp", "Microwave", "Television"}) afford(name, {"switchable"});
  afford("Sink", {"container"});
  for (const auto* name : {"Bowl", "Mug", "Pot"}) afford(name, {"fillable"});

  std::vector<Placement> placements;
  std::vector<Effect> effects;
  for (const auto& name : movable) {
    for (const auto* top : {"Counter", "Shelf", "Table"})
      placements.push_back({name, Predicate::On, top, 0.5, 5, kCurated});
    for (const auto* box : {"Cabinet", "Drawer", "Fridge"})
      placements.push_back({name, Predicate::Inside, box, 0.2, 4, kCurated});
    placements.push_back({name, Predicate::Inside, "Microwave", 0.1, 1, kCurated});
    placements.push_back({name, Predicate::Inside, "Sink", 0.1, 3, kCurated});
  }
  for (const auto* name : {"Bowl", "Mug", "Plate", "Pot"})
    effects.push_back({"Sink", Treatment::Washes, name, "", 0, {}, kCurated});
  for (const auto* name : {"Apple", "Bowl", "Bread", "Mug", "Plate", "Pot"}) {
    effects.push_back(
        {"Microwave", Treatment::Heats, name, "", 0, {EffectNeed::Closed, EffectNeed::PowerOn}, kCurated});
    effects.push_back({"Fridge", Treatment::Cools, name, "", 0, {EffectNeed::Closed}, kCurated});
  }
  for (const auto* name : {"Bowl", "Mug", "Pot"})
    effects.push_back({"Sink", Treatment::Fills, name, "water", 0, {}, kCurated});
  for (const auto* name : {"Bowl", "Pot"}) {
    for (const auto* top : {"Counter", "Table"}) placements.push_back({name, Predicate::NextTo, top, 0.5, 1, kCurated});
  }
  placements.push_back({"Lamp", Predicate::On, "Table", 0.5, 1, kCurated});
  effects.push_back({"Knife", Treatment::Slices, "Apple", "AppleSliced", 4, {EffectNeed::Held}, kCurated});
  effects.push_back({"Knife", Treatment::Slices, "Bread", "BreadSliced", 6, {EffectNeed::Held}, kCurated});
  std::vector<Alias> aliases = {{"Mug", "something to drink from", AliasKind::Function, kCurated},
                                {"Bowl", "something to drink from", AliasKind::Function, kCurated},
                                {"Mug", "coffee cup", AliasKind::Synonym, kCurated},
                                {"Book", "reading matter", AliasKind::Synonym, kCurated},
                                {"Apple", "I am hungry for fruit.", AliasKind::Context, kCurated},
                                {"Pot", "I want to cook soup.", AliasKind::Context, kCurated}};
  return Knowledge(simulator, std::move(categories), std::move(affordances), std::move(placements), std::move(effects),
                   std::move(aliases));
}

const std::vector<Template>& library() {
  static const auto kReading = load_templates(std::filesystem::path(UNIETP_SOURCE_DIR) / "templates/library");
  EXPECT_TRUE(kReading.errors.empty()) << format(kReading.errors.front());
  return kReading.templates;
}

const Template& library_template(const std::string& name) {
  const auto& all = library();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Template& t) { return t.name == name; });
  if (found == all.end()) throw std::runtime_error("no template " + name);
  return *found;
}

bool supports(const Template& source, Simulator simulator) {
  return std::find(source.simulators.begin(), source.simulators.end(), simulator) != source.simulators.end();
}

namespace {

/// Rooms, neighbors, colors, materials, and sizes and nearness from volumes and places along a line.
void draw_comparisons(const EntityList& entities, const Knowledge& knowledge, Rng& rng, Facts& facts) {
  using enum Predicate;
  std::vector<int> volume, place;
  for (std::size_t i = 0; i < entities.size(); ++i) {
    volume.push_back(static_cast<int>(10 + 4 * rng.below(8)));
    place.push_back(static_cast<int>(rng.below(40)));
  }
  for (EntityIndex x; x.index() < entities.size(); ++x) {
    const auto* category = knowledge.find(entities[x].category);
    if (category == nullptr) continue;
    if (!category->colors.empty()) facts.set(Color, x, rng.pick(category->colors));
    if (!category->materials.empty()) facts.set(Material, x, rng.pick(category->materials));
    int others = 0;
    bool large = true, small = true;
    for (EntityIndex y; y.index() < entities.size(); ++y) {
      if (entities[y].kind == Entity::Kind::Room && rng.chance(0.5)) facts.set(InRoom, x, y);
      if (entities[y].kind == Entity::Kind::Room || x == y) continue;
      if (rng.chance(0.1)) facts.set(NextTo, x, y);
      if (entities[y].category == entities[x].category) {
        ++others;
        large = large && 10 * volume[x.index()] >= 13 * volume[y.index()];
        small = small && 10 * volume[y.index()] >= 13 * volume[x.index()];
      }
      bool nearest = true;  // in tenths of a meter
      for (EntityIndex z; z.index() < entities.size(); ++z) {
        if (z == x || z == y || entities[z].category != entities[x].category) continue;
        const int own = std::abs(place[x.index()] - place[y.index()]),
                  more = std::abs(place[z.index()] - place[y.index()]) - own;
        nearest = nearest && 2 * more >= 5 && 5 * more >= own;
      }
      if (nearest) facts.set(Nearest, x, y);
    }
    if (others > 0 && large) facts.set(Size, x, std::string("large"));
    if (others > 0 && small) facts.set(Size, x, std::string("small"));
  }
}

}  // namespace

std::vector<Trace> starts_by_rejection(const Specification& specification, const Knowledge& knowledge, Rng rng,
                                       int tries) {
  using enum Predicate;
  const std::vector<std::pair<std::string, std::vector<Predicate>>> groups = {
      {"openable", {Closed, Open}},   {"switchable", {PowerOff, PowerOn}}, {"dirtyable", {Clean, Dirty}},
      {"sliceable", {Whole, Sliced}}, {"cookable", {Raw, Cooked}},         {"heatable", {RoomTemperature, Hot, Cool}},
      {"fillable", {Empty}}};
  std::set<std::string> names;
  for (const auto& name : categories_of(specification.goal)) names.insert(name);
  for (const auto& start : specification.init) {
    for (const auto& name : categories_of(start)) names.insert(name);
  }
  std::vector<Trace> starts;
  for (int i = 0; i < tries; ++i) {
    Trace trace;
    Facts facts;
    for (const auto& name : names) {
      const auto number = 1 + rng.below(3);
      for (std::uint64_t n = 0; n < number; ++n) {
        const bool room = knowledge.find(name) == nullptr;
        if (room && n > 0) break;
        facts.set_exists(EntityIndex(trace.entities.size()));
        trace.entities.push_back(
            {room ? Entity::Kind::Room : Entity::Kind::Object, name + std::to_string(n), name, ""});
      }
    }
    draw_comparisons(trace.entities, knowledge, rng, facts);
    // Objects of one category mostly share a state or a place, else hardly any start would meet `forall` constraints.
    const bool alike = rng.chance(0.5);
    for (const auto& name : names) {
      std::vector<std::pair<Predicate, EntityIndex>> places;
      for (EntityIndex to; to.index() < trace.entities.size(); ++to) {
        for (const Predicate relation : {On, Inside}) {
          for (const auto& row : knowledge.placements()) {
            if (row.object == name && row.relation == relation && row.receptacle == trace.entities[to].category) {
              places.emplace_back(relation, to);
            }
          }
        }
      }
      std::vector<std::size_t> shared;
      for (const auto& group : groups) shared.push_back(rng.below(group.second.size()));
      const auto shared_place = rng.below(3 * places.size() + 1);
      for (EntityIndex at; at.index() < trace.entities.size(); ++at) {
        if (trace.entities[at].category != name) continue;
        for (std::size_t g = 0; g < groups.size(); ++g) {
          if (!knowledge.has(name, groups[g].first)) continue;
          const auto& states = groups[g].second;
          facts.set(alike ? states[shared[g]] : states[rng.below(states.size())], at);
        }
        const auto place = alike ? shared_place : rng.below(3 * places.size() + 1);
        if (place < places.size()) facts.set(places[place].first, at, places[place].second);
      }
    }
    trace.states.push_back(facts);
    const bool meets = std::all_of(specification.init.begin(), specification.init.end(),
                                   [&](const Formula& start) { return holds_in(start, trace, 0); });
    if (meets) starts.push_back(std::move(trace));
  }
  return starts;
}

}  // namespace unietp
