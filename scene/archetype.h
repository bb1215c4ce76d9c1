#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace unietp {

/// How a category is built from solid parts: which cavities, surfaces, doors and lids it has. The geometry is made by
/// simulation/shape. Object frame: origin at the center of the bounding box, x to the right, y backwards (the front
/// faces -y), z up.
enum class Archetype : std::uint8_t {
  // furniture and fixtures
  Block,    // solid; things stand on top (counter, stove, washing machine without a drum)
  Table,    // top on four legs; things stand on top, and under it
  Seat,     // seat slab with a backrest; things lie on the seat (chair, sofa)
  Bed,      // low mattress block with a headboard
  Shelf,    // open shelves between two sides and a back
  Cabinet,  // hollow, shelves inside, a hinged door in front (fridge, oven, microwave, wardrobe, dishwasher)
  Drawers,  // chest whose top drawer slides out; things stand on top
  Basin,    // block with a hollow that is open above (sink, bathtub)
  Panel,    // thin and upright, on a wall (painting, window, mirror, curtain, light switch)
  Fixture,  // small solid on a wall, a floor or a counter (faucet, shower head, floor lamp)
  // movable
  Box,       // solid box (book, remote control, loaf)
  Cylinder,  // solid upright cylinder (bottle, can, candle)
  Sphere,    // ball (apple, tomato)
  Plate,     // thin slab on which things lie (plate, tray, cutting board)
  Vessel,    // hollow, open above (mug, bowl, pot, basket, bin)
  Lidded,    // hollow with a hinged lid (box, toolbox, cooler)
  Folding,   // two slabs on a hinge (laptop, book that opens)
};

std::string_view name_of(Archetype archetype);  // "cabinet"
/// nullopt for an unknown name.
std::optional<Archetype> archetype_named(std::string_view name);
/// In the order of the enum.
std::span<const Archetype> all_archetypes();

}  // namespace unietp
