#include "bodies.h"
#include "core/files.h"
#include "fuzz_bodies.h"
#include "support.h"

namespace unietp::fuzz {

bool gzip_body(std::string_view text) {
  constexpr std::size_t kMost = 1 << 20;
  const auto packed_here = gunzip("fuzz", gzip(text), kMost);
  require(text.size() > kMost || (packed_here && *packed_here == text));
  const auto unpacked = gunzip("fuzz", text, kMost);
  if (unpacked) {
    require(unpacked->size() <= kMost);
  } else {
    check_error(unpacked.error());
  }
  return static_cast<bool>(unpacked);
}

}  // namespace unietp::fuzz
