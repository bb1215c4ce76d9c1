#pragma once

#include <string>
#include <vector>

#include "akb/knowledge.h"
#include "core/limits.h"
#include "core/result.h"
#include "interchange/source_scene.h"
#include "scene/scene.h"
#include "simulation/profile.h"

namespace unietp {

/// One thing that did not come over as the file says.
struct ImportIssue {
  std::string object, category;  // as the file names them
  std::string reason;            // one of import_reasons()
  std::string detail;            // for people
  bool operator==(const ImportIssue&) const = default;
};

/// The closed list of reasons. Not placed: unknown-category, no-size, not-finite, too-far, outside-rooms, duplicate-id.
/// Placed, and something else was given up: cyclic-containment, unknown-receptacle, unknown-state, typical-size,
/// leaning (taken as the upright box around it), moved (by 2 cm or more when it settled), relation-lost, cut-off (a
/// room that the agent cannot walk to).
const std::vector<std::string>& import_reasons();

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
  std::vector<ImportIssue> issues;
};

/// A scene made of a simulator's file.
struct ImportedScene {
  Scene scene;  // at rest, edges read; tasks can be made in it
  ImportReport report;
};

/// How a file is imported.
struct ImportOptions {
  bool settle = true;                                   // false: as the file says, without physics
  std::size_t most_objects = limits::kImportedObjects;  // a file with more is refused
  std::size_t most_rooms = limits::kImportedRooms;      // the same
};

/// Stage: a file's own account → a scene of ours with each known object at its place. Names are matched with the
/// knowledge base, rooms and openings drawn where the file has none, furniture gets boards where the file shows that
/// something stands; then everything settles in physics and the relations are compared with the file's. What could not
/// be placed is listed, never dropped in silence. Deterministic. Errors: Schema when nothing at all can be placed or
/// the file has too many objects or rooms.
Result<ImportedScene> assemble(const SourceScene& source, const Knowledge& knowledge, const Profile& profile,
                               const ImportOptions& options = {});

}  // namespace unietp
