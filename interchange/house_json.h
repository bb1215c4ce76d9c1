#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "scene/scene.h"

namespace unietp {

// Parts of ProcTHOR's house JSON that follow from little. Coordinates are Unity's.

/// Rounded to 1 / per_unit, and never -0: houses are written to a tenth of a millimeter, angles to a thousandth of a
/// degree.
double house_number(double value, double per_unit);
/// {"x", "y", "z"}, rounded as house_number does.
nlohmann::ordered_json house_xyz(const Vec3& unity, double per_unit = 10000);
/// A point of the floor plan at a height.
nlohmann::ordered_json house_point(const Vec2& w, double height = 0);

/// A material by name, and a plain color (parts from 0 to 1).
nlohmann::ordered_json house_material(std::string_view name);
nlohmann::ordered_json house_paint(double red, double green, double blue);
/// Rooms take turns in four layers, so that a lamp lights its own room only.
std::string house_layer(std::size_t room);

/// Sky, floor, lamps: as real houses have them, a lamp under each room's ceiling.
nlohmann::ordered_json house_parameters(const Scene& scene);
/// Where the agent starts.
nlohmann::ordered_json house_metadata(const Scene& scene);

}  // namespace unietp
