#include <gtest/gtest.h>

#include "../fuzz/fuzz_formula_body.h"
#include "core/rng.h"
#include "random_goals.h"

namespace unietp {
namespace {

// What the fuzz targets check, on a fixed sample: random goals with random bytes changed, dropped and doubled.
TEST(FuzzSample, BrokenFormulasAreRefusedOrReadAndNeverCrash) {
  constexpr std::string_view kBytes = "()?- :;\"\\/\n=<>09aAxrandotxv_\xff\x00";
  int refused = 0, read = 0;
  for (std::uint64_t seed = 0; seed < 3000; ++seed) {
    testing::GoalWriter writer{Rng(seed)};
    std::string text = to_text(writer.goal());
    Rng rng = Rng(seed).fork("break", 0);
    const std::uint64_t changes = rng.below(4);
    for (std::uint64_t i = 0; i < changes && !text.empty(); ++i) {
      const std::size_t at = rng.below(text.size());
      switch (rng.below(3)) {
        case 0:
          text[at] = kBytes[rng.below(kBytes.size())];
          break;
        case 1:
          text.erase(at, 1 + rng.below(5));
          break;
        default:
          text.insert(at, text.substr(rng.below(text.size()), rng.below(12)));
          break;
      }
    }
    fuzz::read_sexprs_body(text);
    (fuzz::parse_formula_body(text) ? read : refused) += 1;
  }
  EXPECT_GT(refused, 1000);
  EXPECT_GT(read, 600) << "texts that were left whole, at least";
}

}  // namespace
}  // namespace unietp
