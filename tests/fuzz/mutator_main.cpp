// Has libFuzzer change most inputs by a mutator that knows their structure (UNIETP_FUZZ_MUTATOR), and the rest, as what
// the mutator cannot read, by bytes.
#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "json_mutator.h"
#include "sqlite_mutator.h"

namespace {

constexpr double kByBytes = 0.25;  // of the inputs

std::string_view text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// Writes the changed text; 0 when there is none that fits.
std::size_t put(const std::optional<std::string>& changed, std::uint8_t* out, std::size_t most) {
  if (!changed || changed->empty() || changed->size() > most) return 0;
  std::copy(changed->begin(), changed->end(), out);
  return changed->size();
}

}  // namespace

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed) {
  unietp::Rng rng(seed);
  if (rng.chance(kByBytes)) return LLVMFuzzerMutate(data, size, most);
  const auto text = text_of(data, size);
  const std::size_t written = put(unietp::fuzz::UNIETP_FUZZ_MUTATOR(text, text, rng), data, most);
  return written > 0 ? written : LLVMFuzzerMutate(data, size, most);
}

extern "C" std::size_t LLVMFuzzerCustomCrossOver(const std::uint8_t* one, std::size_t size, const std::uint8_t* other,
                                                 std::size_t other_size, std::uint8_t* out, std::size_t most,
                                                 unsigned seed) {
  const auto changed =
      unietp::fuzz::UNIETP_FUZZ_MUTATOR(text_of(one, size), text_of(other, other_size), unietp::Rng(seed));
  return put(changed, out, most);
}
