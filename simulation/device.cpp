#include "simulation/device.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>

namespace unietp {
namespace {

/// Parts of categories' names without "_", lower case; the first that fits decides.
constexpr std::array<std::pair<std::string_view, Device>, 38> kWords{{
    {"lighter", Device::Flame},
    {"candle", Device::Flame},
    {"spiritlamp", Device::Flame},
    {"lightswitch", Device::Appliance},
    {"lamp", Device::Lamp},
    {"light", Device::Lamp},
    {"chandelier", Device::Lamp},
    {"flame", Device::Flame},
    {"television", Device::Screen},
    {"tv", Device::Screen},
    {"laptop", Device::Screen},
    {"monitor", Device::Screen},
    {"computer", Device::Screen},
    {"phonograph", Device::Appliance},
    {"microphone", Device::Appliance},
    {"phone", Device::Screen},
    {"screen", Device::Screen},
    {"console", Device::Screen},
    {"calculator", Device::Screen},
    {"camera", Device::Screen},
    {"scoreboard", Device::Screen},
    {"tablet", Device::Screen},
    {"watercooler", Device::Appliance},
    {"burner", Device::Burner},
    {"stove", Device::Burner},
    {"grill", Device::Burner},
    {"heater", Device::Burner},
    {"radiator", Device::Burner},
    {"iron", Device::Burner},
    {"waffle", Device::Burner},
    {"faucet", Device::Tap},
    {"sink", Device::Tap},
    {"shower", Device::Tap},
    {"fountain", Device::Tap},
    {"tub", Device::Tap},
    {"tap", Device::Tap},
    {"hose", Device::Tap},
    {"torch", Device::Lamp},
}};

std::string plain(std::string_view category) {
  std::string text;
  for (const char c : category) {
    if (c != '_') text += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return text;
}

}  // namespace

Device device_of(const Node& node) {
  if (!node.states.has(Predicate::PowerOn) && !node.states.has(Predicate::PowerOff)) return Device::None;
  const std::string name = plain(node.category);
  const auto* const word = std::find_if(kWords.begin(), kWords.end(),
                                        [&](const auto& entry) { return name.find(entry.first) != std::string::npos; });
  return word == kWords.end() ? Device::Appliance : word->second;
}

}  // namespace unietp
