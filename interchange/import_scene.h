#pragma once

#include <string>
#include <vector>

#include "akb/knowledge.h"
#include "core/result.h"
#include "interchange/source_scene.h"
#include "scene/scene.h"
#include "simulation/profile.h"

namespace unietp {

/// One thing that did not come over as the file says.
struct ImportIssue {
  std::string object, category;  // as the file names them
  std::string reason;            // of a closed list: unknown-category, no-size, outside-rooms, not-finite, moved, …
  std::string detail;            // for people
  bool operator==(const ImportIssue&) const = default;
};

/// How much of a file arrived.
struct ImportReport {
  int objects = 0;         // in the file
  int known = 0;           // of a category of the knowledge base
  int arrived = 0;         // of those: stand within 2 cm of the file's pose when the scene is built
  int relations = 0;       // that the file states between known objects
  int relations_held = 0;  // of those: still true after settling
  std::vector<ImportIssue> issues;
};

struct ImportedScene {
  Scene scene;  // at rest, edges read; tasks can be made in it
  ImportReport report;
};

struct ImportOptions {
  bool settle = true;  // false: as the file says, without physics
};

/// Stage: a file's own account → a scene of ours with each known object at its place. Names are matched with the
/// knowledge base, rooms and openings drawn where the file has none, furniture gets boards where the file shows that
/// something stands; then everything settles in physics and the relations are compared with the file's. What could not
/// be placed is listed, never dropped in silence. Deterministic. Errors: Schema when nothing at all can be placed.
Result<ImportedScene> assemble(const SourceScene& source, const Knowledge& knowledge, const Profile& profile,
                               const ImportOptions& options);

}  // namespace unietp
