// Copies of homes with changes, and homes that have nothing to do with each other. With real homes it prints the tables
// of docs/validate.md:
//   UNIETP_HOMES=out/benchmark/homes:out/training/homes validator_tests --gtest_filter='LikenessOfHomes.*'
#include "validator/likeness_of_homes.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/files.h"
#include "core/text.h"
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
    std::vector<Scene> all;
    if (const char* folders = std::getenv("UNIETP_HOMES")) {
      for (const auto& folder : split(folders, ':'))
        for (Scene& home : read_homes(folder)) all.push_back(std::move(home));
    } else {
      for (std::uint64_t number = 0; number < 20; ++number) all.push_back(drawn_home(number));
    }
    return all;
  }();
  return kHomes;
}

/// How many of the likenesses reach each of some thresholds.
void print_row(const std::string& name, const std::vector<double>& likenesses) {
  std::printf("| %s | %zu | %.2f | %.2f |", name.c_str(), likenesses.size(),
              *std::min_element(likenesses.begin(), likenesses.end()),
              *std::max_element(likenesses.begin(), likenesses.end()));
  for (const double threshold : {0.1, 0.15, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9})
    std::printf(" %td |", std::count_if(likenesses.begin(), likenesses.end(),
                                        [threshold](double likeness) { return likeness >= threshold; }));
  std::printf("\n");
}

TEST(LikenessOfHomes, IsFarBelowTheThresholdForHomesOfTheirOwn) {
  std::vector<HomeFingerprint> prints;
  for (const Scene& home : homes()) prints.push_back(print_of_home(home));
  std::vector<double> likenesses;
  for (std::size_t i = 0; i < prints.size(); ++i) {
    EXPECT_EQ(likeness_of_homes(prints[i], prints[i]), 1);
    for (std::size_t j = 0; j < i; ++j) {
      likenesses.push_back(likeness_of_homes(prints[i], prints[j]));
      EXPECT_EQ(likenesses.back(), likeness_of_homes(prints[j], prints[i]));
    }
  }
  const double most = *std::max_element(likenesses.begin(), likenesses.end());
  EXPECT_GT(most, 0);
  EXPECT_LT(most, kSimilarHome);
  print_row("pairs of homes of their own", likenesses);
}

TEST(LikenessOfHomes, IsAboveTheThresholdForCopiesWithChanges) {
  constexpr std::size_t kTries = 20;
  for (const HomeEdit& edit : kHomeEdits) {
    std::vector<double> likenesses;
    for (std::size_t seed = 0; seed < kTries; ++seed) {
      const Scene& home = homes()[seed * homes().size() / kTries];
      const Scene copy = edit.made(home, Rng(3).fork(edit.name, seed));
      likenesses.push_back(likeness_of_homes(print_of_home(home), print_of_home(copy)));
      EXPECT_GE(likenesses.back(), kCopiedHome) << edit.name << ", " << home.id;
    }
    print_row(edit.name, likenesses);
  }
}

TEST(LikenessOfHomes, NeitherNamesNorPlaceInTheWorldMatter) {
  const HomeFingerprint print = print_of_home(homes()[0]);
  for (const HomeEdit& edit : kHomeEdits) {
    const std::string name = edit.name;
    if (name != "mirrored" && name != "renumbered" && !name.starts_with("turned")) continue;
    EXPECT_GT(likeness_of_homes(print, print_of_home(edit.made(homes()[0], Rng(1)))), 0.99) << name;
  }
}

/// What is alike by category must be so without sizes, and the other way round.
TEST(LikenessOfHomes, CategoriesWithRoomTypesAreEnoughAndSoAreSizesWhicheverSideIsFirst) {
  const HomeFingerprint print = print_of_home(homes()[0]);
  Scene of_other_sizes = renumbered(homes()[0], Rng(1));
  edit_nodes(of_other_sizes, [](std::vector<Node>& nodes) {
    for (Node& node : nodes) node.size *= 1.5;
  });
  EXPECT_GT(likeness_of_homes(print, print_of_home(of_other_sizes)), 0.99);
  Scene of_other_names = homes()[0];
  edit_nodes(of_other_names, [](std::vector<Node>& nodes) {
    for (Node& node : nodes) {
      node.category += "X";
      std::swap(node.size.x(), node.size.y());
    }
  });
  EXPECT_GT(likeness_of_homes(print, print_of_home(of_other_names)), 0.99);
}

/// The likenesses of some homes to a copy of theirs; gives their mean.
double mean_of_copies(const std::string& name,
                      const std::function<Scene(const Scene& home, const Scene& other)>& copy) {
  constexpr std::size_t kTries = 20;
  std::vector<double> likenesses;
  for (std::size_t i = 0; i < kTries; ++i) {
    const Scene& home = homes()[i * homes().size() / kTries];
    const Scene& other = homes()[(i + 1) % kTries * homes().size() / kTries];
    likenesses.push_back(likeness_of_homes(print_of_home(home), print_of_home(copy(home, other))));
  }
  print_row(name, likenesses);
  return std::accumulate(likenesses.begin(), likenesses.end(), 0.0) / kTries;
}

TEST(LikenessOfHomes, FallsWithEveryRoomThatIsAnother) {
  double before = 1;
  for (std::size_t kept = 4; kept > 0; --kept) {
    const double mean =
        mean_of_copies(std::to_string(kept) + " rooms kept, the others of another home",
                       [kept](const Scene& home, const Scene& other) { return with_rooms_of(home, kept, other); });
    EXPECT_LT(mean, before);
    before = mean;
  }
  EXPECT_GT(before, 0.05);
}

TEST(LikenessOfHomes, FallsWithTheWayThatEveryObjectIsMoved) {
  double before = 1;
  for (const double way_m : {0.02, 0.05, 0.1, 0.2, 0.5}) {
    const double mean =
        mean_of_copies("every object moved by up to " + number_text(way_m) + " m",
                       [way_m](const Scene& home, const Scene&) { return shaken(home, Rng(8), way_m); });
    EXPECT_LT(mean, before);
    before = mean;
  }
  EXPECT_LT(before, kCopiedHome);
}

TEST(LikenessOfHomes, AnEmptyHomeIsLikeNoOther) {
  EXPECT_EQ(likeness_of_homes(print_of_home(Scene()), print_of_home(Scene())), 0);
  EXPECT_EQ(likeness_of_homes(print_of_home(Scene()), print_of_home(homes()[0])), 0);
}

}  // namespace
}  // namespace unietp::testing
