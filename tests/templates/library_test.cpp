#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "templates/init_shape.h"
#include "templates/rooms_needed.h"
#include "templates/template.h"

namespace unietp {
namespace {

const TemplateReading& library() {
  static const auto kReading = load_templates(std::filesystem::path(UNIETP_SOURCE_DIR) / "templates/library");
  return kReading;
}

TEST(Library, EveryTemplateLoads) {
  std::string errors;
  for (const auto& error : library().errors) errors += format(error) + "\n";
  EXPECT_EQ(errors, "");
}

TEST(Library, NoTwoTemplatesAskForTheSame) {
  std::map<std::string, std::string> name_of_goal;
  for (const auto& t : library().templates) {
    const auto [first, added] = name_of_goal.emplace(to_text(normal_form(t.goal)) + " " + t.refinement, t.name);
    EXPECT_TRUE(added) << t.name << " has the goal of " << first->second;
  }
}

TEST(Library, ATemplateSaysItsGoalInPhrasingsThatDiffer) {
  for (const auto& t : library().templates) {
    EXPECT_GE(t.instructions.size(), 1U) << t.name;
    EXPECT_EQ(std::set<std::string>(t.instructions.begin(), t.instructions.end()).size(), t.instructions.size())
        << t.name;
  }
}

TEST(Library, StartConstraintsKeepToTheShapesThatGroundingEnforces) {
  for (const auto& t : library().templates) {
    for (const auto& start : t.init) EXPECT_FALSE(init_shape_problem(start)) << t.name << ": " << to_text(start);
  }
}

TEST(Library, TemplatesThatBringThingsToAnotherRoomNeedSeveral) {
  std::set<std::string> several;
  for (const auto& t : library().templates) {
    if (needs_several_rooms(t)) several.insert(t.name);
  }
  for (const char* name : {"bring-one-into", "go-to-room", "open-the-one-in-room"})
    EXPECT_TRUE(several.contains(name)) << name;
  for (const char* name : {"close-all-in-room", "place-one-on", "cook-one"})
    EXPECT_FALSE(several.contains(name)) << name;
}

TEST(Library, HabitatGetsNoTemplateThatNeedsPowerOrChangesOfState) {
  const std::vector<Predicate> wanted = {Predicate::PowerOn, Predicate::PowerOff, Predicate::Hot,
                                         Predicate::Cool,    Predicate::Clean,    Predicate::Sliced};
  for (const auto& t : library().templates) {
    if (std::find(t.simulators.begin(), t.simulators.end(), Simulator::Habitat) == t.simulators.end()) continue;
    const auto goal = to_text(t.goal);
    for (const auto predicate : wanted) {
      EXPECT_EQ(goal.find(std::string("(").append(info(predicate).name).append(" ?")), std::string::npos) << t.name;
    }
  }
}

TEST(Library, ReadingTwiceGivesTheSameOrder) {
  const auto again = load_templates(std::filesystem::path(UNIETP_SOURCE_DIR) / "templates/library");
  ASSERT_EQ(again.templates.size(), library().templates.size());
  for (std::size_t i = 0; i < again.templates.size(); ++i) {
    EXPECT_EQ(again.templates[i].name, library().templates[i].name);
    EXPECT_EQ(again.templates[i].goal, library().templates[i].goal);
  }
}

TEST(ParseTemplate, ReadsEverySection) {
  const auto reading = parse_template("store-two.template", R"((template store-two
  (name "store two <A> in <C>")
  (split logical)
  (simulators ai2thor habitat)
  (parameters (A - pickupable) (C - furniture container openable))
  (constraints (distinct A C) (fits-inside A C 2))
  (init (count >= 2 (?a - A) (not (exists (?c - C) (inside ?a ?c)))))
  (goal (exists (?c - C) (at-end (count >= 2 (?a - A) (inside ?a ?c)))))
  (instruction "Store two {A:plural} {C:inside}.")))");
  ASSERT_EQ(reading.templates.size(), 1U) << format(reading.errors.front());
  const auto& t = reading.templates[0];
  EXPECT_EQ(t.name, "store-two");
  EXPECT_EQ(t.title, "store two <A> in <C>");
  EXPECT_EQ(t.split, Split::Logical);
  EXPECT_EQ(t.simulators, (std::vector{Simulator::Ai2thor, Simulator::Habitat}));
  ASSERT_EQ(t.parameters.size(), 2U);
  EXPECT_EQ(t.parameters[1].name, "C");
  EXPECT_EQ(t.parameters[1].affordances, (std::vector<std::string>{"furniture", "container", "openable"}));
  ASSERT_EQ(t.constraints.size(), 2U);
  EXPECT_EQ(t.constraints[1].type, ConstraintType::FitsInside);
  EXPECT_EQ(t.constraints[1].arguments, (std::vector<std::string>{"A", "C", "2"}));
  EXPECT_EQ(to_text(t.init[0]), "(count >= 2 (?a - A) (not (exists (?c - C) (inside ?a ?c))))");
  EXPECT_EQ(to_text(t.goal), "(exists (?c - C) (at-end (count >= 2 (?a - A) (inside ?a ?c))))");
  EXPECT_EQ(t.instructions, (std::vector<std::string>{"Store two {A:plural} {C:inside}."}));
}

TEST(ParseTemplate, AReferringDomainIsNeverEmptyWhenTheStartSaysSo) {
  const std::string head =
      R"((template t (name "t") (split logical) (refinement referring) (parameters (A - openable)) )";
  const std::string tail =
      R"((goal (forall (?a - (A :where (closed ?a))) (at-end (open ?a)))) (instruction "Open {A}.")))";
  EXPECT_TRUE(parse_template("t.template", head + "(init (exists (?x - A) (closed ?x)))" + tail).errors.empty());
  EXPECT_EQ(parse_template("t.template", head + "(init (exists (?x - A) (open ?x)))" + tail).errors.size(), 1U);
  EXPECT_EQ(parse_template("t.template", head + "(init (forall (?x - A) (closed ?x)))" + tail).errors.size(), 1U);
}

TEST(Split, NamesRoundTrip) {
  for (const auto split :
       {Split::Atomic, Split::Compositional, Split::Logical, Split::InstanceGrounding, Split::Linguistic}) {
    EXPECT_EQ(split_named(name_of(split)), split);
  }
  EXPECT_FALSE(split_named("Atomic"));
}

}  // namespace
}  // namespace unietp
