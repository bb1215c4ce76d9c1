#include <algorithm>

#include "bodies.h"
#include "fuzz_bodies.h"
#include "interchange/formats.h"
#include "interchange/import_scene.h"
#include "interchange/scene_models.h"
#include "support.h"

namespace unietp::fuzz {
namespace {

/// A few things that the seeds hold.
Knowledge knowledge_of(Simulator simulator) {
  std::vector<Category> categories;
  std::vector<AffordanceFact> affordances;
  const auto add = [&](const char* name, bool movable, Archetype archetype, const Vec3& size) {
    Category category;
    category.name = category.display = category.plural = name;
    category.movable = movable;
    category.archetype = archetype;
    category.size = size;
    category.mass = 1;
    categories.push_back(category);
    if (archetype == Archetype::Cabinet) affordances.push_back({name, "openable", {"curated", 1}});
  };
  add("armchair", false, Archetype::Seat, {0.8, 0.8, 0.9});
  add("bowl", true, Archetype::Vessel, {0.2, 0.2, 0.08});
  add("fridge", false, Archetype::Cabinet, {0.8, 0.7, 1.8});
  add("kitchentable", false, Archetype::Table, {1.5, 0.9, 0.8});
  add("mug", true, Archetype::Vessel, {0.1, 0.1, 0.1});
  return {simulator, categories, affordances, {}, {}, {}};
}

const FormatFacts& format_facts() {
  static const FormatFacts known{{{"sofa", "couch"}},
                                 {},
                                 {},
                                 {{"livingroom", "living_room"}},
                                 {{"OPEN", Predicate::Open}},
                                 {{"GRABBABLE", "pickupable"}},
                                 {"door", "floor", "floors", "wall"}};
  return known;
}

/// What is read can be assembled or says why not, and nothing is dropped in silence. Gives the scenes that came in.
std::vector<Scene> assembled(const std::vector<SourceScene>& scenes, const Knowledge& knowledge) {
  std::vector<Scene> in;
  for (std::size_t i = 0; i < std::min<std::size_t>(scenes.size(), 3); ++i) {
    auto imported = assemble(scenes[i], knowledge, Profile(), format_facts(), {.settle = false});
    if (!imported) {
      require(!imported.error().message.empty());
      continue;
    }
    const ImportReport& report = imported->report;
    require(report.objects == static_cast<int>(scenes[i].objects.size()));
    require(report.arrived <= report.placed && report.placed <= report.objects);
    require(report.relations_held <= report.relations);
    in.push_back(std::move(imported->scene));
  }
  return in;
}

}  // namespace

bool virtualhome_body(std::string_view text) {
  static const Knowledge knowledge = knowledge_of(Simulator::Virtualhome);
  const auto scenes = read_virtualhome("fuzz", text, knowledge, format_facts());
  if (!scenes) return check_error(scenes.error()), false;
  for (const Scene& scene : assembled(*scenes, knowledge)) {
    const auto out = write_virtualhome(scene, knowledge, format_facts());
    require(out && read_virtualhome("again", out->text, knowledge, format_facts()));
  }
  return true;
}

bool habitat_body(std::string_view text) {
  static const Knowledge knowledge = knowledge_of(Simulator::Habitat);
  const auto scenes = read_habitat("fuzz", text, knowledge, format_facts());
  if (!scenes) return check_error(scenes.error()), false;
  for (const Scene& scene : assembled(*scenes, knowledge)) {
    const auto out = write_habitat(scene, knowledge);
    require(out && read_habitat("again", out->text, knowledge, format_facts()));
  }
  return true;
}

bool behavior_body(std::string_view text) {
  static const Knowledge knowledge = knowledge_of(Simulator::Behavior);
  const auto scenes = read_behavior("fuzz", text, knowledge);
  if (!scenes) return check_error(scenes.error()), false;
  assembled(*scenes, knowledge);
  return true;
}

bool models_body(std::string_view text) {
  const auto models = read_scene_models("fuzz", text);
  const auto inventory = read_behavior_inventory("fuzz", text);
  require(static_cast<bool>(models) == static_cast<bool>(inventory));
  if (!models) return check_error(models.error()), false;
  require(models->size() == inventory->size());
  for (const auto& [name, model] : *models) require(model.mass >= 0 && model.size.minCoeff() >= 0);
  return true;
}

}  // namespace unietp::fuzz
