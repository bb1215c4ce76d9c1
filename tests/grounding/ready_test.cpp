#include <algorithm>
#include <functional>

#include <gtest/gtest.h>

#include "grounding/ground.h"
#include "homes.h"

namespace unietp {
namespace {

/// Starts in homes that are lived in as the committed tables say, each made with the home's seed.
class ReadyStart : public ::testing::Test {
 protected:
  void SetUp() override {
    style_ = style_of(Simulator::Ai2thor);
    ASSERT_TRUE(style_);
  }
  /// The starts of a goal in a few homes, where there are any.
  std::vector<Scene> starts(const std::string& goal, const std::vector<std::string>& init,
                            std::uint64_t homes = 6) const {
    std::vector<Scene> all;
    for (std::uint64_t seed = 1; seed <= homes; ++seed) {
      auto home = full_home_of(*style_, seed);
      if (!home) continue;
      const Home prepared = prepare_home(std::move(*home), style_->profile);
      GroundingOptions options;
      options.household = style_->recipe.household.get();
      options.likely = true;
      auto result = ground(specification(goal, init), prepared, style_->knowledge, style_->profile, options, Rng(seed));
      if (auto* start = std::get_if<Grounded>(&result)) all.push_back(std::move(start->episode.start));
    }
    EXPECT_GE(all.size(), 2u) << goal;
    return all;
  }
  /// Of the things of the category that are (not) on or in a category of the test, those with the state, and all.
  struct Number {
    int with = 0, all = 0;
  };
  static Number number(const std::vector<Scene>& starts, const std::string& category, Predicate state,
                       const std::function<bool(const std::string& host)>& left_out) {
    Number number;
    for (const Scene& scene : starts) {
      for (const Node& node : scene.nodes) {
        if (node.category != category) continue;
        const bool out = std::any_of(scene.edges.begin(), scene.edges.end(), [&](const Edge& edge) {
          const Node* host = find_node(scene, edge.to);
          return edge.from == node.id && (edge.relation == Predicate::On || edge.relation == Predicate::Inside) &&
                 host != nullptr && left_out(host->category);
        });
        if (out) continue;
        ++number.all;
        if (node.states.has(state)) ++number.with;
      }
    }
    return number;
  }
  std::function<bool(const std::string&)> washes() const {
    return [this](const std::string& host) { return style_->recipe.household->washes(host); };
  }
  std::function<bool(const std::string&)> puts_away() const {
    return [this](const std::string& host) {
      return style_->recipe.household->puts_away(host) || style_->recipe.household->washes(host);
    };
  }

  std::optional<Surroundings> style_;
};

/// One mug in twenty that is not in a sink or a dishwasher is dirty in a home where nothing is asked for, so few homes
/// would show nothing.
TEST_F(ReadyStart, HasCleanDishesForATable) {
  const auto made =
      starts("(exists (?a - Mug) (exists (?b - DiningTable) (at-end (on ?a ?b))))",
             {"(exists (?a - Mug) (and))", "(forall (?a - Mug) (not (exists (?b - DiningTable) (on ?a ?b))))"}, 40);
  const auto clean = number(made, "Mug", Predicate::Clean, washes());
  EXPECT_EQ(clean.with, clean.all);
  EXPECT_GT(clean.all, 2);
}

TEST_F(ReadyStart, HasDirtyDishesStandingAboutForASink) {
  const auto made =
      starts("(exists (?a - Mug) (exists (?b - Sink) (at-end (inside ?a ?b))))",
             {"(exists (?a - Mug) (and))", "(forall (?a - Mug) (not (exists (?b - Sink) (inside ?a ?b))))"});
  const auto dirty = number(made, "Mug", Predicate::Dirty, puts_away());
  EXPECT_EQ(dirty.with, dirty.all);
  EXPECT_GT(dirty.all, 1);
}

TEST_F(ReadyStart, HasACleanPlateForFood) {
  const auto made = starts("(exists (?a - Apple) (exists (?b - Plate) (at-end (on ?a ?b))))",
                           {"(exists (?a - Apple) (and))", "(exists (?b - Plate) (and))",
                            "(forall (?a - Apple) (not (exists (?b - Plate) (on ?a ?b))))"});
  const auto clean = number(made, "Plate", Predicate::Clean, washes());
  EXPECT_EQ(clean.with, clean.all);
}

TEST_F(ReadyStart, LeavesAStateAloneThatTheTaskSpeaksOf) {
  const auto made = starts("(exists (?a - Mug) (exists (?b - DiningTable) (at-end (and (clean ?a) (on ?a ?b)))))",
                           {"(exists (?a - Mug) (dirty ?a))", "(forall (?a - Mug) (not (clean ?a)))",
                            "(forall (?a - Mug) (not (exists (?b - DiningTable) (on ?a ?b))))"});
  EXPECT_EQ(number(made, "Mug", Predicate::Clean, [](const std::string&) { return false; }).with, 0);
}

}  // namespace
}  // namespace unietp
