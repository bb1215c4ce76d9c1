#include "core/png.h"

#include <cassert>

#include <png.h>

namespace unietp {

Result<std::string> png(int width, int height, std::span<const std::uint8_t> rgb) {
  assert(rgb.size() == 3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(width);
  image.height = static_cast<png_uint_32>(height);
  image.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::string bytes(size, '\0');
  if (png_image_write_to_memory(&image, bytes.data(), &size, 0, rgb.data(), 0, nullptr) == 0)
    return Error{Error::Kind::Io, "png", {}, image.message};
  bytes.resize(size);
  return bytes;
}

}  // namespace unietp
