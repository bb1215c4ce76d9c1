// Copies of homes with changes, against homes that have nothing to do with each other. Homes of one's own:
//   UNIETP_HOMES=out/benchmark/homes validator_tests --gtest_filter='LikenessOfHomes.*'
// prints the table of docs/validate.md.
#include "validator/likeness_of_homes.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include <gtest/gtest.h>

#include "core/files.h"
#include "scene/scene_json.h"
#include "tests/validator/edited_homes.h"
#include "validator/nearest_tasks.h"

namespace unietp::testing {
namespace {

std::vector<Scene> read_homes(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::vector<Scene> homes;
  for (const auto& file : files) {
    const auto text = read_maybe_gzip(file);
    auto home = text ? scene_from_json(file.string(), *text) : Result<Scene>(text.error());
    if (!home) ADD_FAILURE() << format(home.error());
    if (home) homes.push_back(std::move(*home));
  }
  return homes;
}

const std::vector<Scene>& homes() {
  static const std::vector<Scene> kHomes = [] {
    if (const char* folder = std::getenv("UNIETP_HOMES")) return read_homes(folder);
    std::vector<Scene> drawn;
    for (std::uint64_t number = 0; number < 20; ++number) drawn.push_back(drawn_home(number));
    return drawn;
  }();
  return kHomes;
}

TEST(LikenessOfHomes, IsFarBelowTheThresholdForHomesOfTheirOwn) {
  std::vector<HomePrint> prints;
  for (const Scene& home : homes()) prints.push_back(print_of_home(home));
  double most = 0;
  for (std::size_t i = 0; i < prints.size(); ++i) {
    EXPECT_EQ(likeness_of_homes(prints[i], prints[i]), 1);
    for (std::size_t j = 0; j < i; ++j) {
      const double likeness = likeness_of_homes(prints[i], prints[j]);
      EXPECT_EQ(likeness, likeness_of_homes(prints[j], prints[i]));
      most = std::max(most, likeness);
    }
  }
  EXPECT_GT(most, 0);
  EXPECT_LT(most, kSimilarHome);
  std::printf("%-45s          at most %.2f\n", "homes of their own", most);
}

TEST(LikenessOfHomes, IsAboveTheThresholdForCopiesWithChanges) {
  constexpr std::size_t kTries = 20;
  for (const HomeEdit& edit : kHomeEdits) {
    std::size_t caught = 0;
    double least = 1;
    for (std::size_t seed = 0; seed < kTries; ++seed) {
      const Scene& home = homes()[seed * homes().size() / kTries];
      const Scene copy = edit.made(home, Rng(3).fork(edit.name, seed));
      const double likeness = likeness_of_homes(print_of_home(home), print_of_home(copy));
      least = std::min(least, likeness);
      if (likeness >= kCopiedHome) ++caught;
    }
    EXPECT_EQ(caught, kTries) << edit.name << ": " << least;
    std::printf("%-45s %2zu of %zu  at least %.2f\n", edit.name, caught, kTries, least);
  }
}

TEST(LikenessOfHomes, NeitherNamesNorPlaceInTheWorldMatter) {
  const HomePrint print = print_of_home(homes()[0]);
  for (const HomeEdit& edit : kHomeEdits) {
    const std::string name = edit.name;
    if (name != "mirrored" && name != "renumbered" && !name.starts_with("turned")) continue;
    EXPECT_GT(likeness_of_homes(print, print_of_home(edit.made(homes()[0], Rng(1)))), 0.99) << name;
  }
}

TEST(LikenessOfHomes, FallsWithEveryRoomThatIsAnother) {
  const Scene home = drawn_home(1), other = drawn_home(2);
  double before = 2;
  for (std::size_t kept = home.rooms.size(); kept > 0; --kept) {
    const Scene mixed = with_rooms_of(home, kept, other);
    const double likeness = likeness_of_homes(print_of_home(home), print_of_home(mixed));
    EXPECT_LT(likeness, before) << kept;
    EXPECT_NEAR(likeness, static_cast<double>(kept) / 5, 0.2) << kept;
    before = likeness;
  }
}

TEST(LikenessOfHomes, AnEmptyHomeIsLikeNoOther) {
  EXPECT_EQ(likeness_of_homes(print_of_home(Scene()), print_of_home(Scene())), 0);
  EXPECT_EQ(likeness_of_homes(print_of_home(Scene()), print_of_home(homes()[0])), 0);
}

}  // namespace
}  // namespace unietp::testing
