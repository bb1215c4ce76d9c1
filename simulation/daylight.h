#pragma once

#include <optional>
#include <vector>

#include "scene/scene.h"
#include "simulation/camera.h"

namespace unietp {

/// A window through which daylight falls into the room before it.
struct Daylight {
  Vec3 at = Vec3::Zero();                     // middle of the pane, W
  Vec3 inward = Vec3::Zero();                 // unit, level, W
  Vec2 half = Vec2::Zero();                   // half width and half height of the pane, meters
  const Room* room = nullptr;                 // never null
  Bounds around{Vec3::Zero(), Vec3::Zero()};  // of the room
};

/// Of the windows that lie up to `farthest` meters from the camera. The scene must outlive them.
std::vector<Daylight> daylight_of(const Scene& scene, const Camera& camera, double farthest);

/// Light of the sky on a face, of each color as a share of daylight: by the size of the pane, the angles and the
/// square of the distance, up to 5 m. Nothing but walls is in its way.
Vec3 sky_light(const std::vector<Daylight>& windows, const Vec3& at, const Vec3& normal);

/// Unit, W: where the sun stands, in the northeast at 45 degrees.
Vec3 toward_sun();
/// Meters along toward_sun() from a point to the glass through which the sun would shine on it: not to the frame, nor
/// to the bars that divide the pane in four. nullopt where there is none.
std::optional<double> way_to_sunny_pane(const std::vector<Daylight>& windows, const Vec3& at);

}  // namespace unietp
