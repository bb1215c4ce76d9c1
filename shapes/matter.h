#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace unietp {

/// What a surface is made of, as far as the eye can tell.
enum class Matter : std::uint8_t {
  Plain,
  Plastic,
  Metal,
  Glass,
  Wood,
  Fabric,
  Paper,
  Ceramic,
  Leather,
  Stone,
  Cardboard,
  Rubber,
  Wicker,
  Wax,
  Foam,
  Food
};

/// Red, green and blue.
using Rgb = std::array<std::uint8_t, 3>;

/// A material with the color of things of it whose color is not known.
struct Material {
  std::string_view name;
  Rgb color{};
  Matter matter = Matter::Plain;
};

/// nullptr for a name that is no color; "" too.
const Rgb* color_named(std::string_view name);
/// nullptr for a name that is no material; "" too.
const Material* material_named(std::string_view name);
/// For messages, in the order of the tables.
std::vector<std::string> color_names();
std::vector<std::string> material_names();  // likewise

}  // namespace unietp
