#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/result.h"
#include "simulation/channels.h"

namespace unietp {

/// What the pixels of a picture hold.
enum class Channel : std::uint8_t { Color, Depth, Normals, Instances };
inline constexpr std::array kChannels{Channel::Color, Channel::Depth, Channel::Normals, Channel::Instances};
std::string_view name_of(Channel channel);  // "color", "depth", "normals", "instances"
/// nullopt for another word.
std::optional<Channel> channel_named(std::string_view name);

/// Channels as PNG files of the size of the picture. Deterministic. Errors: those of core/png.h.

/// 16 bits gray: millimeters; 0 where nothing is or what is there is more than 65.535 m away.
Result<std::string> depth_png(const Channels& channels);
/// Red, green, blue: right, down and ahead in the camera's frame, -1 to 1 as 0 to 255.
Result<std::string> normals_png(const Channels& channels);
/// 16 bits gray: position of the node plus 1; 0 for walls, floor, ceiling and where nothing is.
Result<std::string> instances_png(const Channels& channels);
/// One of these three; `channel` is not Color, which Channels do not have.
Result<std::string> channel_png(const Channels& channels, Channel channel);

}  // namespace unietp
