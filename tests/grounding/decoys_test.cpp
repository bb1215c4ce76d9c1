#include "grounding/decoys.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "grounding/ground.h"
#include "homes.h"

namespace unietp {
namespace {

/// Starts of "put a mug on the table" in homes that people live in, where so many mugs have to be there.
class DecoyStart : public ::testing::Test {
 protected:
  void SetUp() override {
    style_ = style_of(Simulator::Ai2thor);
    ASSERT_TRUE(style_);
  }
  Home home(std::uint64_t seed) const {
    auto made = full_home_of(*style_, seed);
    EXPECT_TRUE(made);
    return prepare_home(std::move(*made), style_->profile);
  }
  std::optional<Episode> start(const Home& home, std::size_t mugs, bool decoys) const {
    GroundingOptions options;
    options.household = style_->recipe.household.get();
    options.decoys = decoys;
    auto result = ground(specification("(exists (?a - Mug) (exists (?b - DiningTable) (at-end (on ?a ?b))))",
                                       {"(count >= " + std::to_string(mugs) + " (?a - Mug) (and))",
                                        "(forall (?a - Mug) (not (exists (?b - DiningTable) (on ?a ?b))))"}),
                         home, style_->knowledge, style_->profile, options, Rng(7));
    auto* grounded = std::get_if<Grounded>(&result);
    return grounded == nullptr ? std::nullopt : std::optional(std::move(grounded->episode));
  }
  static std::map<std::string, std::vector<const Node*>> added_to(const Home& home, const Scene& start) {
    std::map<std::string, std::vector<const Node*>> added;
    for (const Node& node : start.nodes) {
      if (!home.places.find(node.id)) added[node.category].push_back(&node);
    }
    return added;
  }
  static std::string category_below(const Scene& scene, const Node& node) {
    for (const Edge& edge : scene.edges) {
      if (edge.from == node.id && (edge.relation == Predicate::On || edge.relation == Predicate::Inside))
        return find_node(scene, edge.to)->category;
    }
    return {};
  }
  static const Room* room_of(const Scene& scene, const Node& node) {
    return room_at(scene, node.pose.position.head<2>());
  }

  std::optional<Surroundings> style_;
};

TEST_F(DecoyStart, HasOtherThingsThatWereAddedToTheSameRooms) {
  int starts = 0, complete = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const Home lived_in = home(seed);
    const std::size_t mugs = lived_in.places.of("Mug").size();
    const auto made = start(lived_in, mugs + 2, true);
    if (!made) continue;
    ++starts;
    auto added = added_to(lived_in, made->start);
    ASSERT_EQ(added["Mug"].size(), 2u);
    std::multiset<const Room*> rooms;
    for (const Node* mug : added["Mug"]) rooms.insert(room_of(made->start, *mug));
    if (added.size() == 1 + kDecoys) ++complete;
    for (const auto& [category, things] : added) {
      EXPECT_EQ(things.size(), 2u) << category;
      std::multiset<const Room*> theirs;
      for (const Node* thing : things) theirs.insert(room_of(made->start, *thing));
      EXPECT_EQ(theirs, rooms) << category;
      EXPECT_NEAR(static_cast<double>(lived_in.places.of(category).size()), static_cast<double>(mugs), 2) << category;
      EXPECT_TRUE(category == "Mug" || style_->knowledge.find(category)->display != "cup") << "which may be a mug";
    }
  }
  EXPECT_GE(starts, 3);
  EXPECT_GE(complete, starts - 1);
}

TEST_F(DecoyStart, IsOtherwiseWhatItWouldBeWithoutThem) {
  int starts = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const Home lived_in = home(seed);
    const std::size_t mugs = lived_in.places.of("Mug").size() + 1;
    const auto plain = start(lived_in, mugs, false), made = start(lived_in, mugs, true);
    ASSERT_EQ(plain.has_value(), made.has_value());
    if (!made) continue;
    ++starts;
    EXPECT_GT(made->start.nodes.size(), plain->start.nodes.size());
    for (const Node& node : plain->start.nodes) {
      const Node* same = find_node(made->start, node.id);
      ASSERT_NE(same, nullptr) << node.id;
      EXPECT_TRUE(*same == node || (node.category != "Mug" && node.movable)) << node.id;
    }
    EXPECT_EQ(start(lived_in, mugs, true)->start, made->start);
  }
  EXPECT_GE(starts, 2);
}

TEST_F(DecoyStart, HasOtherThingsThatWereMovedToTheSameRooms) {
  int moved_mugs = 0, moved_others = 0, alone = 0;
  for (std::uint64_t seed = 1; seed <= 150; ++seed) {
    const Home lived_in = home(seed);
    const auto made = start(lived_in, 1, true);
    if (!made) continue;
    std::set<const Room*> of_mugs, of_others;
    std::vector<std::pair<const Room*, std::string>> others;
    for (const Node& node : made->start.nodes) {
      const auto before = lived_in.places.find(node.id);
      if (!node.movable || !before || lived_in.scene.nodes[*before].pose.position == node.pose.position) continue;
      const Room* room = room_of(made->start, node);
      if (node.category == "Mug") {
        of_mugs.insert(room);
        ++moved_mugs;
      } else {
        of_others.insert(room);
        others.emplace_back(room, node.category);
      }
    }
    moved_others += static_cast<int>(others.size());
    alone += std::includes(of_others.begin(), of_others.end(), of_mugs.begin(), of_mugs.end()) ? 0 : 1;
    for (const auto& [room, category] : others)
      EXPECT_TRUE(of_mugs.contains(room) || !style_->recipe.household->is_found_in(category, room->type)) << category;
    EXPECT_TRUE(!of_mugs.empty() || others.empty());
  }
  EXPECT_GE(moved_mugs, 1);
  EXPECT_LE(alone, moved_mugs / 10) << "of " << moved_mugs;
  EXPECT_GE(moved_others, 2 * moved_mugs);
}

/// A table on which everything stands at once, or three kettles, is where a visitor stops.
TEST_F(DecoyStart, CrowdsNoPlaceAndMultipliesNothingThatHomesHaveOnce) {
  const Household& household = *style_->recipe.household;
  int came = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const Home lived_in = home(seed);
    for (const std::size_t more : {0u, 2u}) {
      const auto made = start(lived_in, lived_in.places.of("Mug").size() + more, true);
      if (!made) continue;
      std::map<std::string, int> at, added, moved;  // by place; by category
      for (const Edge& edge : made->start.edges) {
        const Node* node = find_node(made->start, edge.from);
        if ((edge.relation != Predicate::On && edge.relation != Predicate::Inside) || node == nullptr ||
            !node->movable || node->category == "Mug")
          continue;
        const auto before = lived_in.places.find(node->id);
        if (before && lived_in.scene.nodes[*before].pose.position == node->pose.position) continue;
        ++came;
        ++at[edge.to];
        ++(before ? moved : added)[node->category];
        const Node* place = find_node(made->start, edge.to);
        EXPECT_NE(place == nullptr ? "" : place->category, "Mug") << node->id << " in what the task is about";
      }
      for (const auto& [place, number] : at) EXPECT_LE(number, 4) << place << " in home " << seed;
      for (const auto& [category, number] : moved)
        EXPECT_LE(number, household.has_several(category) ? 4 : 2) << category << " in home " << seed;
      for (const auto& [category, number] : added) {
        if (!household.has_several(category)) {
          EXPECT_LE(lived_in.places.of(category).size() + static_cast<std::size_t>(number), 2u) << category;
        }
      }
    }
  }
  EXPECT_GT(came, 30);
}

/// "Put a spoon on the counter" where a spoon has to be in the living room, as in no home of Habitat: so are other
/// things that homes do not have where they are then.
TEST_F(DecoyStart, HasOtherThingsAstrayWhereHomesHaveNone) {
  style_ = style_of(Simulator::Habitat);
  ASSERT_TRUE(style_);
  const Household& household = *style_->recipe.household;
  int starts = 0, astray = 0;
  for (std::uint64_t seed = 1; seed <= 32; ++seed) {
    const Home lived_in = home(seed);
    GroundingOptions options;
    options.household = &household;
    options.decoys = true;
    const auto result = ground(specification("(exists (?a - spoon) (exists (?b - counter) (at-end (on ?a ?b))))",
                                             {"(exists (?a - spoon) (exists (?r - living_room) (in_room ?a ?r)))",
                                              "(forall (?a - spoon) (not (exists (?b - counter) (on ?a ?b))))"}),
                               lived_in, style_->knowledge, style_->profile, options, Rng(7));
    const auto* grounded = std::get_if<Grounded>(&result);
    if (grounded == nullptr || lived_in.places.of("spoon").empty()) continue;
    ++starts;
    for (const Node& node : grounded->episode.start.nodes) {
      const auto before = lived_in.places.find(node.id);
      if (!node.movable || !before || node.category == "spoon" ||
          lived_in.scene.nodes[*before].pose.position == node.pose.position)
        continue;
      astray += household.is_found_in(node.category, room_of(grounded->episode.start, node)->type) ? 0 : 1;
    }
  }
  EXPECT_GE(starts, 3);
  EXPECT_GE(astray, 5 * starts);
}

/// "Hold a mug" in a home that gets two more of them, and all are dirty: so are others that were added and can be.
TEST_F(DecoyStart, HasOtherThingsThatWereAddedInTheSameStatesAndPlaces) {
  int washable = 0, dirty = 0, others = 0, together = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const Home lived_in = home(seed);
    GroundingOptions options;
    options.household = style_->recipe.household.get();
    options.decoys = true;
    const std::string more = std::to_string(lived_in.places.of("Mug").size() + 1);
    const auto result =
        ground(specification("(exists (?a - Mug) (at-end (held ?a)))",
                             {"(count >= " + more + " (?a - Mug) (and))", "(forall (?a - Mug) (dirty ?a))"}),
               lived_in, style_->knowledge, style_->profile, options, Rng(7));
    const auto* grounded = std::get_if<Grounded>(&result);
    if (grounded == nullptr) continue;
    const Scene& start = grounded->episode.start;
    const auto added = added_to(lived_in, start);
    const std::string below = category_below(start, *added.at("Mug").front());
    for (const auto& [category, things] : added) {
      if (category == "Mug") continue;
      for (const Node* thing : things) {
        ++others;
        together += category_below(start, *thing) == below ? 1 : 0;
        washable += style_->knowledge.has(category, info(Predicate::Dirty).group) ? 1 : 0;
        dirty += thing->states.has(Predicate::Dirty) ? 1 : 0;
      }
    }
  }
  EXPECT_GE(washable, 3);
  EXPECT_GE(4 * dirty, washable) << "in homes, few things are dirty";
  EXPECT_GE(8 * together, others) << "a place takes few";
}

/// "Hold a mug" in a home where all mugs have to be dirty: other things are dirty, too, that were clean.
TEST_F(DecoyStart, HasOtherThingsInTheStatesThatItGaveThingsOfTheGoal) {
  int starts = 0, others = 0, given = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const Home lived_in = home(seed);
    for (const bool decoys : {false, true}) {
      GroundingOptions options;
      options.household = style_->recipe.household.get();
      options.decoys = decoys;
      const auto result =
          ground(specification("(exists (?a - Mug) (at-end (held ?a)))", {"(forall (?a - Mug) (dirty ?a))"}), lived_in,
                 style_->knowledge, style_->profile, options, Rng(7));
      const auto* grounded = std::get_if<Grounded>(&result);
      if (grounded == nullptr) continue;
      ++starts;
      for (const Node& node : grounded->episode.start.nodes) {
        const auto before = lived_in.places.find(node.id);
        if (!before || !node.movable || !node.states.has(Predicate::Dirty) ||
            lived_in.scene.nodes[*before].states.has(Predicate::Dirty))
          continue;
        if (node.category == "Mug") {
          given += decoys ? 1 : 0;
        } else {
          EXPECT_TRUE(decoys) << node.id;
          ++others;
        }
      }
    }
  }
  EXPECT_GE(starts, 6);
  EXPECT_GE(given, 1);
  EXPECT_GE(others, given);
}

TEST_F(DecoyStart, HasOtherSlicesOnDishesOrWhereTheyAreKept) {
  GroundingOptions options;
  options.household = style_->recipe.household.get();
  options.decoys = true;
  int slices = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const Home lived_in = home(seed);
    const auto made =
        ground(specification("(exists (?a - BreadSliced) (at-end (hot ?a)))", {"(exists (?a - BreadSliced) (and))"}),
               lived_in, style_->knowledge, style_->profile, options, Rng(7));
    const auto* grounded = std::get_if<Grounded>(&made);
    if (grounded == nullptr) continue;
    const Scene& scene = grounded->episode.start;
    for (const auto& [category, nodes] : added_to(lived_in, scene)) {
      if (category == "BreadSliced" || !category.ends_with("Sliced")) continue;
      ++slices;
      EXPECT_NE(category_below(scene, *nodes.front()), "CounterTop") << category << " in home " << seed;
    }
  }
  EXPECT_GT(slices, 3);
}

TEST_F(DecoyStart, IsTheHomeWhereNothingOfTheGoalWasChangedAndItHasOne) {
  int starts = 0;
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    const Home lived_in = home(seed);
    const auto plain = start(lived_in, 1, false), made = start(lived_in, 1, true);
    if (!plain || !plain->edits.empty() || lived_in.places.of("Mug").size() > 1) continue;
    ++starts;
    EXPECT_EQ(made->start, plain->start);
  }
  EXPECT_GE(starts, 1);
}

TEST_F(DecoyStart, HasOthersAsOftenWhereNothingWasChangedAndItHasSeveral) {
  int starts = 0;
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    const Home lived_in = home(seed);
    const std::size_t mugs = lived_in.places.of("Mug").size();
    const auto plain = start(lived_in, 1, false), made = start(lived_in, 1, true);
    if (!plain || !plain->edits.empty() || mugs < 2) continue;
    ++starts;
    const auto added = added_to(lived_in, made->start);
    EXPECT_GE(added.size(), 2U);
    EXPECT_FALSE(added.contains("Mug"));
    int as_many = 0;
    for (const auto& [category, things] : added) {
      EXPECT_EQ(things.size(), 1U) << category;
      as_many += lived_in.places.of(category).size() + 1 == mugs ? 1 : 0;
    }
    EXPECT_GE(as_many, 1);
  }
  EXPECT_GE(starts, 1);
}

}  // namespace
}  // namespace unietp
