#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "core/result.h"

namespace unietp {

/// The bytes of a PNG file. `rgb`: rows from the top, three bytes a pixel, width * height of them, both greater than 0.
/// Equal pixels give equal bytes with one version of libpng and zlib. Errors: Io when libpng refuses.
Result<std::string> png(int width, int height, std::span<const std::uint8_t> rgb);

/// The same in a fraction of the bytes: colors are rounded to 32 levels a channel, and the 256 most frequent of them
/// stand for all.
Result<std::string> few_colors_png(int width, int height, std::span<const std::uint8_t> rgb);

/// The bytes of a PNG file of one channel of 16 bits. `gray`: rows from the top, width * height values. Determinism and
/// errors as above.
Result<std::string> gray_png(int width, int height, std::span<const std::uint16_t> gray);

}  // namespace unietp
