#include <algorithm>

#include "bodies.h"
#include "fuzz_bodies.h"
#include "interchange/formats.h"
#include "interchange/import_scene.h"
#include "support.h"

namespace unietp::fuzz {
namespace {

/// A few things that the seeds hold.
const Knowledge& knowledge() {
  static const Knowledge known = [] {
    std::vector<Category> categories;
    const auto add = [&](const char* name, bool movable, Archetype archetype, const Vec3& size) {
      Category category;
      category.name = category.display = category.plural = name;
      category.movable = movable;
      category.archetype = archetype;
      category.size = size;
      category.mass = 1;
      categories.push_back(category);
    };
    add("DiningTable", false, Archetype::Table, {1.5, 0.9, 0.8});
    add("Fridge", false, Archetype::Cabinet, {0.8, 0.7, 1.8});
    add("Laptop", true, Archetype::Folding, {0.4, 0.3, 0.02});
    add("Mug", true, Archetype::Vessel, {0.1, 0.1, 0.1});
    add("Window", false, Archetype::Panel, {1, 0.1, 1});
    return Knowledge(Simulator::Ai2thor, categories,
                     {{"Fridge", "openable", {"curated", 1}}, {"Laptop", "openable", {"curated", 1}}}, {}, {}, {},
                     {{"Dining_Table_1", "DiningTable", {1.5, 0.9, 0.8}, {"curated", 1}},
                      {"Mug_1", "Mug", {0.1, 0.1, 0.1}, {"curated", 1}},
                      {"Window_1", "Window", {1, 0.1, 1}, {"curated", 1}}});
  }();
  return known;
}

const FormatFacts& facts() {
  static const FormatFacts known{
      {},
      {{"Doorframe_1", 1.08, 2.13}},
      {{"Bathroom", "Tiles"}, {"Bedroom", "Wood"}, {"Kitchen", "Tiles"}, {"LivingRoom", "Wood"}},
      {},
      {},
      {},
      {"door", "floor", "wall"}};
  return known;
}

/// What is read can be assembled or says why not, and what is written of it reads again.
bool check(const Result<std::vector<SourceScene>>& scenes) {
  if (!scenes) return check_error(scenes.error()), false;
  for (std::size_t i = 0; i < std::min<std::size_t>(scenes->size(), 3); ++i) {
    const SourceScene& source = (*scenes)[i];
    const auto imported = assemble(source, knowledge(), Profile(), facts(), {.settle = source.objects.size() < 8});
    if (!imported) {
      require(!imported.error().message.empty());
      continue;
    }
    const ImportReport& report = imported->report;
    require(report.objects == static_cast<int>(source.objects.size()));
    require(report.arrived <= report.placed && report.placed <= report.objects);
    require(report.relations_held <= report.relations && report.loose_held <= report.loose);
    for (const ImportIssue& issue : report.issues) {
      require(!name_of(issue.reason).empty() && !issue.detail.empty());
    }
    const auto written = write_procthor(imported->scene, knowledge(), facts());
    require(static_cast<bool>(written));
    require(static_cast<bool>(read_procthor("written", written->text, knowledge())));
  }
  return true;
}

}  // namespace

bool ithor_body(std::string_view text) { return check(read_ithor("fuzz", text)); }
bool procthor_body(std::string_view text) { return check(read_procthor("fuzz", text, knowledge())); }

}  // namespace unietp::fuzz
