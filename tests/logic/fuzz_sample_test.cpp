#include <gtest/gtest.h>

#include "../fuzz/fuzz_formula_body.h"
#include "../fuzz/sample/broken.h"
#include "core/rng.h"
#include "random_goals.h"

namespace unietp {
namespace {

// What the fuzz targets check, on a fixed sample: random goals, three of four with bytes changed, dropped and doubled.
TEST(FuzzSample, BrokenFormulasAreRefusedOrReadAndNeverCrash) {
  int refused = 0, read = 0;
  for (std::uint64_t seed = 0; seed < 3000; ++seed) {
    testing::GoalWriter writer{Rng(seed)};
    std::string text = to_text(writer.goal());
    Rng rng = Rng(seed).fork("break", 0);
    if (seed % 4 != 0) text = fuzz::broken(std::move(text), rng);
    fuzz::read_sexprs_body(text);
    (fuzz::parse_formula_body(text) ? read : refused) += 1;
  }
  EXPECT_GT(refused, 1000);
  EXPECT_GE(read, 750) << "texts that were left whole, at least";
}

}  // namespace
}  // namespace unietp
