#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "akb/knowledge.h"
#include "core/limits.h"
#include "core/result.h"
#include "interchange/format_facts.h"
#include "interchange/source_scene.h"
#include "scene/scene.h"
#include "simulation/profile.h"

namespace unietp {

/// Why something did not come over as the file says.
enum class ImportReason : std::uint8_t {
  CutOff,             // a room that the agent cannot walk to
  CyclicContainment,  // placed; it would hold what holds it
  DuplicateId,        // not placed
  Leaning,            // placed as the upright box around it
  Moved,              // placed; by 2 cm or more when it settled
  NoSize,             // not placed
  NotFinite,          // not placed
  OutsideRooms,       // not placed
  RelationLost,       // placed, but no longer where the file says
  Restless,           // placed; held where it is, since it does not come to rest
  TooFar,             // not placed
  TypicalSize,        // placed with the size of its category
  UnknownCategory,    // not placed
  UnknownReceptacle,  // placed; the file has no such object
  UnknownState,       // placed without it
};
std::string_view name_of(ImportReason reason);  // "cut-off"
/// What is done then, for people: "left out".
std::string_view treatment_of(ImportReason reason);

/// One thing that did not come over as the file says.
struct ImportIssue {
  std::string object, category;  // as the file names them
  ImportReason reason = ImportReason::CutOff;
  std::string detail;  // for people
  bool operator==(const ImportIssue&) const = default;
};

/// What was changed of an object that is in the home, so that the home holds together. Each has a distance.
enum class RepairKind : std::uint8_t {
  Board,    // something hangs above all its solids: a board was put under that; the air below it
  Cut,      // something else, a door on its way or the floor is inside one of its solids: cut away there; how deep
  Lowered,  // it stood higher than what stands beside it: set down to one level
  Settled,  // moved when everything came to rest
  Surface,  // things stand above or below its surface: moved to where they stand
  Turned,   // it could not be opened for what stands right before it: turned; how far its front moved
};
std::string_view name_of(RepairKind kind);  // "cut"
/// What was wrong and what was done, for people.
std::string_view meaning_of(RepairKind kind);

/// One repair.
struct ImportRepair {
  std::string object, category;  // of what was changed, as the file names it
  std::string node;              // the same in the scene
  RepairKind kind = RepairKind::Cut;
  std::string other;  // for what it was changed, as the file names it; "" when it is for itself
  double by_m = 0;    // > 0
  bool operator==(const ImportRepair&) const = default;
};

/// How much of a file arrived. What a home is built of (floors, walls, doors) is drawn as rooms and openings and counts
/// among the objects when its category is known.
struct ImportReport {
  int objects = 0;         // in the file
  int known = 0;           // of a category of the knowledge base
  int placed = 0;          // of those: stand in the scene
  int arrived = 0;         // of those: stand within 2 cm of the file's pose when the scene is built
  int stayed = 0;          // of those: still do after settling
  int relations = 0;       // that the file states between known objects
  int relations_held = 0;  // of those: still true after settling
  int loose = 0;           // of the relations: those whose object can move
  int loose_held = 0;      // of those: still true after settling, as physics shows it
  int rooms_drawn = 0;     // around the objects, of a file without rooms
  int openings_made = 0;   // in shared walls, of a file without openings
  std::vector<ImportIssue> issues;
  std::vector<ImportRepair> repairs;  // from a millimeter on, in order of the nodes
};

/// A scene made of a simulator's file.
struct ImportedScene {
  Scene scene;  // at rest, edges read; tasks can be made in it
  ImportReport report;
};

/// How a file is imported.
struct ImportOptions {
  bool settle = true;                                   // false: as the file says, without physics
  bool own_ids = false;                                 // objects and rooms keep the simulator's ids
  std::size_t most_objects = limits::kImportedObjects;  // a file with more is refused
  std::size_t most_rooms = limits::kImportedRooms;      // the same
  std::size_t most_work = limits::kMostWork;            // of physics; then everything is held in place
};

/// Stage: a file's own account → a scene of ours with each known object at its place. Names are matched with the
/// knowledge base, rooms and openings drawn where the file has none, furniture gets boards where the file shows that
/// something stands; then everything settles in physics and the relations are compared with the file's. What could not
/// be placed is listed, never dropped in silence. Deterministic. Errors: Schema when nothing at all can be placed or
/// the file has too many objects or rooms.
Result<ImportedScene> assemble(const SourceScene& source, const Knowledge& knowledge, const Profile& profile,
                               const FormatFacts& facts, const ImportOptions& options = {});

}  // namespace unietp
