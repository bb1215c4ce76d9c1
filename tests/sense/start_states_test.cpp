#include "sense/start_states.h"

#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "akb/provenance.h"
#include "core/files.h"
#include "tests/sense/committed_sense.h"
#include "tests/support/scratch_folder.h"

namespace unietp {
namespace {

using ::testing::HasSubstr;

const StartStates& committed() {
  static const StartStates states = [] {
    std::vector<Error> errors;
    auto read = read_start_states(test::sense_tables() / "start_states.csv", test::committed_sense().kinds(), errors);
    for (const auto& error : errors) ADD_FAILURE() << format(error);
    return read;
  }();
  return states;
}

double share(const std::string& kind, const Role& place, Predicate state, const std::string& substance = "") {
  return committed().share(kind, place, {state, substance}).value_or(-1);
}

TEST(StartStates, AreThoseOfALivedInHomeByDay) {
  EXPECT_EQ(share("plate", "in:kitchen_cabinet", Predicate::Dirty), 0);
  EXPECT_GT(share("plate", "in:sink", Predicate::Dirty), 0.7);
  EXPECT_GT(share("curtain", "", Predicate::Open), 0.8);
  EXPECT_LT(share("room_lamp", "", Predicate::PowerOn), 0.2);
  EXPECT_LT(share("fridge", "", Predicate::Open), 0.05);
  EXPECT_EQ(share("sink", "", Predicate::PowerOn), 0);
  EXPECT_EQ(share("stove", "", Predicate::PowerOn), 0);
  EXPECT_EQ(share("dairy", "in:fridge", Predicate::Cool), 1);
  EXPECT_GT(share("garment", "in:dresser", Predicate::Folded), share("garment", "on:floor", Predicate::Folded));
}

TEST(StartStates, AreLookedUpByThePlaceFirstAndThenByTheNarrowerKind) {
  const StartStates states(test::committed_sense().kinds(),
                           {{{Predicate::Dirty, ""}, 0.1, "movable", "", "curated"},
                            {{Predicate::Dirty, ""}, 0.2, "plate", "", "curated"},
                            {{Predicate::Dirty, ""}, 0.3, "movable", "in:cabinet", "curated"},
                            {{Predicate::Dirty, ""}, 0.4, "cup", "in:cabinet", "curated"}});
  EXPECT_EQ(states.share("plate", "", {Predicate::Dirty, ""}), 0.2);
  EXPECT_EQ(states.share("plate", "on:shelf", {Predicate::Dirty, ""}), 0.2);
  EXPECT_EQ(states.share("plate", "in:kitchen_cabinet", {Predicate::Dirty, ""}), 0.3);
  EXPECT_EQ(states.share("cup", "in:kitchen_cabinet", {Predicate::Dirty, ""}), 0.4);
  EXPECT_EQ(states.share("glass", "", {Predicate::Dirty, ""}), 0.1);
  EXPECT_EQ(states.share("plate", "", {Predicate::Open, ""}), std::nullopt);
  EXPECT_EQ(states.of("plate", "in:kitchen_cabinet").size(), 1U);
}

TEST(StartStates, ThatExcludeOneAnotherShareOne) {
  std::vector<Role> places{""};
  for (const auto& kind : test::committed_sense().kinds().all()) {
    if (kind.relation.empty()) continue;
    for (const auto* relation : {"on", "in"})
      places.push_back(test::committed_sense().kinds().place_role(relation, kind.name));
  }
  for (const auto& kind : test::committed_sense().kinds().all()) {
    for (const auto& place : places) {
      std::map<std::size_t, double> sum;  // by group
      for (const auto& row : committed().of(kind.name, place)) {
        for (std::size_t i = 0; i < state_groups().size(); ++i) {
          const auto& group = state_groups()[i].predicates;
          if (std::find(group.begin(), group.end(), row.state.predicate) != group.end()) sum[i] += row.share;
        }
      }
      for (const auto& [group, total] : sum)
        EXPECT_LE(total, 1 + 1e-9) << kind.name << " " << place << " " << state_groups()[group].affordance;
    }
  }
}

TEST(StartStates, OfABadTableAreRefusedWithTheirPlace) {
  const ScratchFolder folder;
  const auto path = folder.path() / "s.csv";
  ASSERT_TRUE(write_file(path,
                         "thing,place,state,substance,share,source\nplat,,dirty,,0.1,curated\n"
                         "plate,at:sink,dirty,,0.1,curated\nplate,,dirtyy,,0.1,curated\n"
                         "plate,,dirty,water,0.1,curated\ncup,,filled,,0.1,curated\nplate,,dirty,,1.5,curated\n"
                         "plate,,dirty,,0.1,curated\nplate,,dirty,,0.2,curated\n"));
  std::vector<Error> errors;
  read_start_states(path, test::committed_sense().kinds(), errors);
  std::vector<int> lines;
  for (const auto& error : errors) lines.push_back(error.pos.line);
  EXPECT_THAT(lines, ::testing::ElementsAre(2, 3, 4, 5, 6, 7, 9));
}

}  // namespace
}  // namespace unietp
