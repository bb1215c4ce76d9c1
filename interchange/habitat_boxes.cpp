#include "interchange/habitat_boxes.h"

#include <algorithm>
#include <utility>

#include "interchange/box_facing.h"
#include "interchange/foreign_json.h"

namespace unietp {

SourceScene read_labeled_boxes(JsonReader& reader, const JsonAt& home, std::string id, const Knowledge& knowledge) {
  SourceScene scene;
  scene.id = std::move(id);
  scene.simulator = Simulator::Habitat;
  const auto list = given(home, "objects");
  if (!list) return scene;
  const std::size_t count = objects_in(reader, *list);
  for (std::size_t i = 0; i < count && !reader.error(); ++i) {
    const JsonAt at = reader.item(*list, i);
    JsonFields fields(reader, at);
    SourceObject object;
    object.id = "box_" + std::to_string(i);
    if (const auto f = given(at, "category")) object.category = reader.text(*f);
    const auto center = fields.required("center"), size = fields.required("size");
    if (!center || !size) break;
    object.pose.position = reader.vec3(*center);
    const Vec3 extents = reader.vec3(*size);
    if (!reader.error() && extents.minCoeff() < 0) reader.fail(*size, "expected three lengths >= 0");
    const Category* category = knowledge.find(object.category);
    const Facing facing =
        facing_of_box(object.pose.position, extents, category == nullptr ? Vec3::Zero() : category->size, false, {});
    object.pose = upright(object.pose.position, facing.yaw);
    object.size = facing.size;
    if (object.category == "wall") scene.wall_height = std::max(scene.wall_height, extents.z());
    scene.objects.push_back(std::move(object));
  }
  return scene;
}

}  // namespace unietp
