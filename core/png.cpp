#include "core/png.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <vector>

#include <png.h>

namespace unietp {
namespace {

png_image image_of(int width, int height, png_uint_32 format) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(width);
  image.height = static_cast<png_uint_32>(height);
  image.format = format;
  return image;
}

Result<std::string> written(png_image image, const void* pixels, const std::uint8_t* colors) {
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::string bytes(size, '\0');
  if (png_image_write_to_memory(&image, bytes.data(), &size, 0, pixels, 0, colors) == 0)
    return Error{Error::Kind::Io, "png", {}, image.message};
  bytes.resize(size);
  return bytes;
}

using Color = std::array<std::uint8_t, 3>;

// Colors are told apart by five bits a channel. Their numbers are in the order of the colors.
constexpr std::size_t kNumbers = 1 << 15;
std::size_t number_of(const std::uint8_t* rgb) {
  return static_cast<std::size_t>((rgb[0] >> 3) << 10 | (rgb[1] >> 3) << 5 | rgb[2] >> 3);
}
Color color_of(std::size_t number) {
  const auto channel = [&](int shift) {
    const std::size_t five = number >> shift & 31;
    return static_cast<std::uint8_t>(five << 3 | five >> 2);
  };
  return {channel(10), channel(5), channel(0)};
}

int distance(const Color& a, const Color& b) {
  int sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return sum;
}

/// At most 256 colors, the most frequent ones, and for the number of each color of the image the one that replaces it.
std::vector<std::uint8_t> palette_of(std::span<const std::uint8_t> rgb, std::vector<std::uint8_t>& palette) {
  std::vector<int> counts(kNumbers, 0);
  for (std::size_t i = 0; i < rgb.size(); i += 3) ++counts[number_of(&rgb[i])];
  std::vector<std::pair<Color, int>> most;
  for (std::size_t number = 0; number < kNumbers; ++number) {
    if (counts[number] > 0) most.emplace_back(color_of(number), counts[number]);
  }
  std::stable_sort(most.begin(), most.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
  constexpr std::size_t kColors = 256;
  most.resize(std::min(most.size(), kColors));
  for (const auto& [color, count] : most) palette.insert(palette.end(), color.begin(), color.end());
  std::vector<std::uint8_t> index(kNumbers, 0);
  for (std::size_t number = 0; number < kNumbers; ++number) {
    if (counts[number] == 0) continue;
    const Color color = color_of(number);
    const auto nearest = std::min_element(most.begin(), most.end(), [&](const auto& a, const auto& b) {
      return distance(a.first, color) < distance(b.first, color);
    });
    index[number] = static_cast<std::uint8_t>(nearest - most.begin());
  }
  return index;
}

}  // namespace

Result<std::string> png(int width, int height, std::span<const std::uint8_t> rgb) {
  assert(rgb.size() == 3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  return written(image_of(width, height, PNG_FORMAT_RGB), rgb.data(), nullptr);
}

Result<std::string> few_colors_png(int width, int height, std::span<const std::uint8_t> rgb) {
  assert(rgb.size() == 3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  std::vector<std::uint8_t> palette, pixels;
  const auto index = palette_of(rgb, palette);
  pixels.reserve(rgb.size() / 3);
  for (std::size_t i = 0; i < rgb.size(); i += 3) pixels.push_back(index[number_of(&rgb[i])]);
  png_image image = image_of(width, height, PNG_FORMAT_RGB_COLORMAP);
  image.colormap_entries = static_cast<png_uint_32>(palette.size() / 3);
  return written(image, pixels.data(), palette.data());
}

Result<std::string> gray_png(int width, int height, std::span<const std::uint16_t> gray) {
  assert(gray.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  return written(image_of(width, height, PNG_FORMAT_LINEAR_Y), gray.data(), nullptr);
}

}  // namespace unietp
