#include "bodies.h"
#include "core/limits.h"
#include "fuzz_bodies.h"
#include "shapes/device.h"
#include "shapes/library.h"
#include "support.h"

namespace unietp::fuzz {

bool shapes_body(std::string_view text) {
  const std::size_t tables = text.rfind("++++\n");
  const DeviceTable devices =
      read_devices("devices.csv", tables == std::string_view::npos ? "part,device\n" : text.substr(tables + 5));
  for (const Error& error : devices.errors) check_error(error);
  for (const DeviceRow& row : devices.rows) require(device_of(devices.rows, row.part) == row.device);
  text = text.substr(0, tables);
  const std::size_t end = text.find("====\n");
  const ShapeLibrary::File families{"fuzz.shapes", std::string(text.substr(0, end))};
  const ShapeLibrary::File categories{
      "categories.csv", std::string(end == std::string_view::npos ? "match,name,family\n" : text.substr(end + 5))};
  const ShapeLibraryReading reading = read_shape_library({families}, categories);
  for (const Error& error : reading.errors) {
    check_error(error);
    require(error.pos.line >= 1 && error.pos.column >= 1);
  }
  for (const ShapeFamily& family : reading.library.families()) {
    for (const Vec3& size : {Vec3(0.1, 0.2, 0.3), Vec3(2, 0.01, 1)}) {
      const auto pieces = pieces_of(family, {size, 0.004, 7, {}});
      require(pieces.size() <= limits::kShapePieces);
      for (const Piece& piece : pieces) require(piece.center.allFinite() && piece.axes.allFinite());
    }
    for (const Error& fault : faults_of(family, {0.1, 0.2, 0.3}, 0.004)) check_error(fault);
  }
  (void)reading.library.family_of(Simulator::Ai2thor, "CoffeeMug", Archetype::Vessel);
  return reading.errors.empty() && devices.errors.empty();
}

}  // namespace unietp::fuzz
