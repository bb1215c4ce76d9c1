#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "akb/knowledge.h"
#include "core/result.h"
#include "interchange/format_facts.h"
#include "interchange/source_scene.h"

namespace unietp {

// Readers and writers of the simulators' own scene files. `where` names the text in errors. A file that holds several
// homes (JSON lines; a `scenes` object; a JSON array) gives several.
// Errors: Parse or Schema with the place in the text (line and column, or a JSON pointer) and what is accepted: text
// that is no JSON, a field that is missing or of another type, numbers that are not finite.

/// AI2-THOR: the objects of an iTHOR scene, as its metadata lists them.
Result<std::vector<SourceScene>> read_ithor(const std::string& where, std::string_view text);
/// AI2-THOR: houses of ProcTHOR.
Result<std::vector<SourceScene>> read_procthor(const std::string& where, std::string_view text,
                                               const Knowledge& knowledge);
/// VirtualHome: scene graphs.
Result<std::vector<SourceScene>> read_virtualhome(const std::string& where, std::string_view text,
                                                  const Knowledge& knowledge, const FormatFacts& facts);
/// Habitat: scene instances of ReplicaCAD and HSSD, and labeled boxes.
Result<std::vector<SourceScene>> read_habitat(const std::string& where, std::string_view text,
                                              const Knowledge& knowledge, const FormatFacts& facts);
/// BEHAVIOR: scene files of OmniGibson.
Result<std::vector<SourceScene>> read_behavior(const std::string& where, std::string_view text,
                                               const Knowledge& knowledge);

/// A file of a simulator that loads it, and what of the scene that format cannot say.
struct ExportedScene {
  std::string text;
  std::vector<std::string> left_out;               // for people: "mug_3: no AI2-THOR asset fits its box"
  std::map<std::string, std::string> names = {};   // of our objects, by id, where the file names its objects
  std::map<std::string, std::string> models = {};  // of our objects, by id, in a house of AI2-THOR
};
/// Whether a thing of a category may be on or in something of another.
using MayHold = std::function<bool(const std::string& thing, const std::string& place)>;
/// A house for AI2-THOR's CreateHouse, a VirtualHome environment graph, a Habitat scene instance. Deterministic.
/// `may_hold`: of a house, what is on or in something else is left out with all that it holds, but for objects of a
/// house of ProcTHOR's own; without it all stays. Errors: for a scene of another simulator; for a house, also without a
/// room.
Result<ExportedScene> write_procthor(const Scene& scene, const Knowledge& knowledge, const FormatFacts& facts,
                                     const MayHold& may_hold = {});
/// The id in a house of each of a scene's rooms: its own in a house of ProcTHOR's, for others the next of "room|2", ….
std::vector<std::string> procthor_room_ids(const Scene& scene);
Result<ExportedScene> write_virtualhome(const Scene& scene, const Knowledge& knowledge, const FormatFacts& facts);
/// The names of such a graph alone, in a fraction of the time. `scene`: of VirtualHome.
std::map<std::string, std::string> virtualhome_names(const Scene& scene, const Knowledge& knowledge,
                                                     const FormatFacts& facts);
Result<ExportedScene> write_habitat(const Scene& scene, const Knowledge& knowledge);
/// An OmniGibson scene. `pos` is the middle of an object's box, since no file tells where a model's root link is in it.
/// `names` has each room's floor, too. Deterministic. Errors: as above.
Result<ExportedScene> write_behavior(const Scene& scene, const Knowledge& knowledge);
/// Whether such a scene has an object: one that OmniGibson has a model of.
bool has_behavior_model(const Node& node, const Knowledge& knowledge);
/// The same with an unscaled stand-in (habitat_assets.h) for the model of what is no object of a scene of Habitat's.
Result<ExportedScene> write_habitat_with_stand_ins(const Scene& scene, const Knowledge& knowledge);

/// The formats of scene files. Two are Habitat's.
enum class SceneFormat : std::uint8_t { Ithor, Procthor, Virtualhome, Replicacad, Hssd, Behavior };
std::string_view name_of(SceneFormat format);  // "ithor"
/// In the order of the enum.
const std::vector<std::string>& scene_format_names();
/// nullopt for an unknown name.
std::optional<SceneFormat> scene_format_named(std::string_view name);

}  // namespace unietp
