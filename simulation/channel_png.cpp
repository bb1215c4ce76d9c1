#include "simulation/channel_png.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/png.h"

namespace unietp {

std::string_view name_of(Channel channel) {
  constexpr std::array<std::string_view, kChannels.size()> kNames{"color", "depth", "normals", "instances"};
  return kNames[static_cast<std::size_t>(channel)];
}

std::optional<Channel> channel_named(std::string_view name) {
  const auto* const found =
      std::find_if(kChannels.begin(), kChannels.end(), [&](Channel one) { return name_of(one) == name; });
  return found == kChannels.end() ? std::nullopt : std::optional(*found);
}

Result<std::string> depth_png(const Channels& channels) {
  constexpr double kMost = std::numeric_limits<std::uint16_t>::max();
  std::vector<std::uint16_t> millimeters;
  millimeters.reserve(channels.depth.size());
  for (const float depth : channels.depth) {
    const double value = std::round(1000.0 * depth);
    millimeters.push_back(static_cast<std::uint16_t>(value <= kMost ? value : 0));
  }
  return gray_png(channels.width, channels.height, millimeters);
}

Result<std::string> normals_png(const Channels& channels) {
  std::vector<std::uint8_t> rgb;
  rgb.reserve(channels.normal.size());
  for (const float part : channels.normal) rgb.push_back(static_cast<std::uint8_t>(std::round((part + 1.0) * 127.5)));
  return png(channels.width, channels.height, rgb);
}

Result<std::string> instances_png(const Channels& channels) {
  std::vector<std::uint16_t> numbers;
  numbers.reserve(channels.node.size());
  for (const std::int32_t node : channels.node) numbers.push_back(static_cast<std::uint16_t>(node + 1));
  return gray_png(channels.width, channels.height, numbers);
}

Result<std::string> channel_png(const Channels& channels, Channel channel) {
  assert(channel != Channel::Color);
  if (channel == Channel::Depth) return depth_png(channels);
  return channel == Channel::Normals ? normals_png(channels) : instances_png(channels);
}

}  // namespace unietp
