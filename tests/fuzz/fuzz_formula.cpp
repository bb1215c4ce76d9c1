#include "fuzz_formula_body.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  unietp::fuzz::parse_formula_body({reinterpret_cast<const char*>(data), size});
  return 0;
}
