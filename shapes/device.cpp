#include "shapes/device.h"

#include <algorithm>
#include <array>
#include <utility>

#include "akb/row_reader.h"
#include "core/in_quotes.h"
#include "core/text.h"

namespace unietp {
namespace {

constexpr std::array<std::pair<std::string_view, Device>, 6> kDevices{{{"lamp", Device::Lamp},
                                                                       {"screen", Device::Screen},
                                                                       {"burner", Device::Burner},
                                                                       {"tap", Device::Tap},
                                                                       {"flame", Device::Flame},
                                                                       {"appliance", Device::Appliance}}};

std::vector<std::string> device_names() {
  std::vector<std::string> names;
  for (const auto& [name, device] : kDevices) names.emplace_back(name);
  return names;
}

std::optional<Device> device_named(std::string_view name) {
  for (const auto& [known, device] : kDevices) {
    if (known == name) return device;
  }
  return std::nullopt;
}

std::string plain(std::string_view category) {
  std::string text = lower(category);
  std::erase(text, '_');
  return text;
}

}  // namespace

DeviceTable read_devices(std::string_view where, std::string_view text) {
  DeviceTable table;
  RowReader reader(std::string(where), text, {"part", "device"}, table.errors);
  for (const CsvRow& row : reader.rows()) {
    reader.at(row);
    DeviceRow one{reader.required("part"), reader.value_of("device", device_names(), "device", device_named)};
    if (one.part != plain(one.part)) reader.fail("part", "expected lower case without \"_\"");
    for (const DeviceRow& before : table.rows) {
      if (one.part.find(before.part) == std::string::npos) continue;
      reader.fail("part", "is never used: the row of " + in_quotes(before.part) + " above decides for it");
      break;
    }
    if (reader.sound()) table.rows.push_back(std::move(one));
  }
  return table;
}

Device device_of(const std::vector<DeviceRow>& rows, std::string_view category) {
  const std::string name = plain(category);
  const auto row = std::find_if(rows.begin(), rows.end(),
                                [&](const DeviceRow& one) { return name.find(one.part) != std::string::npos; });
  return row == rows.end() ? Device::Appliance : row->device;
}

}  // namespace unietp
