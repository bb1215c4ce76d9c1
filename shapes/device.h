#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"

namespace unietp {

/// What a device that is switched on shows.
enum class Device : std::uint8_t {
  None,       // cannot be switched
  Lamp,       // glows and lights what is near it
  Screen,     // shows a picture on its front
  Burner,     // glows on its top
  Tap,        // water runs
  Flame,      // burns at its top
  Appliance,  // a lit window and a lamp on its front
};

/// A row of data/shapes/devices.csv: categories with this part in their names are such devices.
struct DeviceRow {
  std::string part;  // lower case, without "_"
  Device device = Device::Appliance;
  bool operator==(const DeviceRow&) const = default;
};
/// In the order of the file. Errors: Parse and Schema with file, line and column; all of them. A row that an earlier
/// one hides is an error.
struct DeviceTable {
  std::vector<DeviceRow> rows;
  std::vector<Error> errors;
};
DeviceTable read_devices(std::string_view where, std::string_view text);
/// The device of the first row whose part is in the category's name, in any case and with "_" left out; Appliance where
/// no row fits.
Device device_of(const std::vector<DeviceRow>& rows, std::string_view category);

/// The rows of data/shapes/devices.csv when the program was built. Thread-safe; made at the first call.
const std::vector<DeviceRow>& built_in_devices();

}  // namespace unietp
