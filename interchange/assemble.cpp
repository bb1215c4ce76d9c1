#include <array>
#include <utility>

#include "core/limits.h"
#include "interchange/draft.h"
#include "scene/scene_size.h"
#include "simulation/relations.h"

namespace unietp {
namespace {

constexpr std::array<std::string_view, 15> kReasons{
    "cut-off",          "cyclic-containment", "duplicate-id",  "leaning",  "moved",   "no-size",
    "not-finite",       "outside-rooms",      "relation-lost", "restless", "too-far", "typical-size",
    "unknown-category", "unknown-receptacle", "unknown-state"};  // in the order of the enum

constexpr std::array<std::string_view, 15> kImportTreatments{"kept; the agent cannot walk into it",
                                                             "kept without the relation",
                                                             "left out",
                                                             "kept as the upright box around it",
                                                             "kept where it came to rest",
                                                             "left out",
                                                             "left out",
                                                             "left out",
                                                             "kept where it is",
                                                             "kept in place, fixed: it cannot be picked up",
                                                             "left out",
                                                             "kept with the usual size of its category",
                                                             "left out",
                                                             "kept without the relation",
                                                             "kept without the state"};

constexpr std::array<std::pair<std::string_view, std::string_view>, 6> kRepairNames{
    {{"board", "something hung in the air above it: a board was put under that"},
     {"cut", "something else, a door on its way or the floor was inside it: cut away there"},
     {"lowered", "it stood higher than what stands beside it: set down to one level"},
     {"settled", "it was not at rest: let go until it was"},
     {"surface", "things stood above or below its surface: the surface was moved to them"},
     {"turned", "its front was shut by what stands right before it: turned to where it opens"}}};

std::string more_than(std::size_t count, std::size_t most, const std::string& what) {
  return std::to_string(count) + " " + what + "; accepted are at most " + std::to_string(most);
}

}  // namespace

std::string_view name_of(ImportReason reason) { return kReasons[static_cast<std::size_t>(reason)]; }
std::string_view treatment_of(ImportReason reason) { return kImportTreatments[static_cast<std::size_t>(reason)]; }
std::string_view name_of(RepairKind kind) { return kRepairNames[static_cast<std::size_t>(kind)].first; }
std::string_view meaning_of(RepairKind kind) { return kRepairNames[static_cast<std::size_t>(kind)].second; }

Result<ImportedScene> assemble(const SourceScene& source, const Knowledge& knowledge, const Profile& profile,
                               const FormatFacts& facts, const ImportOptions& options) {
  const auto refuse = [&](std::string message) {
    return Error{Error::Kind::Schema, source.id, {}, std::move(message)};
  };
  if (source.objects.size() > options.most_objects) {
    return refuse(more_than(source.objects.size(), options.most_objects, "objects"));
  }
  if (source.rooms.size() > options.most_rooms) {
    return refuse(more_than(source.rooms.size(), options.most_rooms, "rooms"));
  }
  Scene scene;
  scene.id = source.id;
  scene.simulator = source.simulator;
  draw_rooms(source, scene, options.own_ids);
  if (std::string wrong = excess_of(scene); !wrong.empty()) return refuse(std::move(wrong));
  Draft draft = draft_of(source, std::move(scene), knowledge, facts, options.own_ids);
  if (draft.scene.rooms.empty()) return refuse("the file has no rooms, and no objects around which to draw one");
  if (source.rooms.empty()) draft.report.rooms_drawn = static_cast<int>(draft.scene.rooms.size());
  if (source.openings.empty()) draft.report.openings_made = static_cast<int>(draft.scene.openings.size());
  if (draft.scene.nodes.empty()) {
    const bool nameless = std::none_of(source.objects.begin(), source.objects.end(),
                                       [](const SourceObject& object) { return !object.category.empty(); });
    return refuse(
        std::string("no object of a known category can be placed") +
        (nameless ? ": the file names models by hashes, so it needs a table of their categories (--assets)" : ""));
  }
  fix_heaps(source, draft);
  turn_fronts(source, facts, draft);
  follow_evidence(draft);
  clear_doors(draft);
  draft.report.arrived = count_in_place(source, draft, !options.settle);
  if (options.settle) come_to_rest(source, options.most_work, draft);
  place_agent(source, profile, draft);
  draft.scene.edges = read_relations(draft.scene);
  draft.report.stayed = count_in_place(source, draft, options.settle);
  compare_relations(source, facts, draft);
  report_repairs(source, draft);
  return ImportedScene{std::move(draft.scene), std::move(draft.report)};
}

}  // namespace unietp
