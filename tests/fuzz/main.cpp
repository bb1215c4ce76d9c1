#include <cstddef>
#include <cstdint>

#include "bodies.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  unietp::fuzz::UNIETP_FUZZ_BODY({reinterpret_cast<const char*>(data), size});
  return 0;
}
