#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "generator/specification.h"
#include "generator/weighted_binding.h"
#include "small_home.h"

namespace unietp {
namespace {

/// All combinations of categories and types of room, kept when the scan of the tables says they fit.
std::vector<Binding> bindings_by_brute_force(const Template& source, const Knowledge& knowledge) {
  std::set<std::string> words;
  for (const auto& category : knowledge.categories()) {
    words.insert(category.name);
    for (const auto* list : {&category.rooms, &category.colors, &category.materials}) {
      words.insert(list->begin(), list->end());
    }
  }
  std::vector<Binding> open = {{}}, found;
  for (const auto& parameter : source.parameters) {
    std::vector<Binding> longer;
    for (const auto& binding : open) {
      for (const auto& word : words) {
        longer.push_back(binding);
        longer.back().emplace_back(parameter.name, word);
      }
    }
    open = std::move(longer);
  }
  for (auto& binding : open) {
    if (fits_by_scan(source, binding, knowledge)) found.push_back(std::move(binding));
  }
  std::sort(found.begin(), found.end());
  return found;
}

TEST(EnumerateBindings, FindsExactlyWhatBruteForceFinds) {
  const auto knowledge = small_home(Simulator::Ai2thor);
  for (const auto& source : library()) {
    if (source.parameters.size() > 3 || !supports(source, Simulator::Ai2thor))
      continue;  // 22^4 combinations take too long here
    SCOPED_TRACE(source.name);
    EXPECT_EQ(enumerate_bindings(source, knowledge, 100000), bindings_by_brute_force(source, knowledge));
  }
}

TEST(EnumerateBindings, StopsAtTheLimitWithTheFirstOnes) {
  const auto knowledge = small_home(Simulator::Ai2thor);
  const auto& source = library_template("place-one-on");
  const auto all = enumerate_bindings(source, knowledge, 1000);
  const auto few = enumerate_bindings(source, knowledge, 7);
  ASSERT_EQ(few.size(), 7U);
  EXPECT_TRUE(std::equal(few.begin(), few.end(), all.begin()));
  EXPECT_TRUE(enumerate_bindings(source, knowledge, 0).empty());
}

TEST(EnumerateBindings, IsEmptyWhereTheTemplateIsNotMeantForTheSimulator) {
  EXPECT_TRUE(enumerate_bindings(library_template("wash-one"), small_home(Simulator::Habitat), 10).empty());
  EXPECT_FALSE(sample_binding(library_template("wash-one"), small_home(Simulator::Habitat), {}, Rng(1)));
}

TEST(SampleBinding, MeetsTheConstraintsForEverySeedAndTemplateThatTheHomeCanFill) {
  const auto knowledge = small_home(Simulator::Ai2thor);
  std::size_t filled = 0;
  for (const auto& source : library()) {
    if (!supports(source, Simulator::Ai2thor)) continue;
    SCOPED_TRACE(source.name);
    const bool fills = !enumerate_bindings(source, knowledge, 1).empty();
    filled += fills ? 1 : 0;
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
      const auto binding = sample_binding(source, knowledge, {}, Rng(seed));
      ASSERT_EQ(binding.has_value(), fills);
      if (!binding) break;
      EXPECT_TRUE(fits_by_scan(source, *binding, knowledge)) << seed;
      EXPECT_EQ(binding, sample_binding(source, knowledge, {}, Rng(seed))) << "not deterministic";
    }
  }
  EXPECT_GE(filled, 59U);
}

TEST(SampleBinding, DrawsTheFirstPlaceholderUniformlyOverCategoriesThatCanBeCompleted) {
  const auto knowledge = small_home(Simulator::Ai2thor);
  const auto& source = library_template("wash-and-place-on");
  std::map<std::string, int> drawn;
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    ++drawn[sample_binding(source, knowledge, {}, Rng(seed))->front().second];
  }
  ASSERT_EQ(drawn.size(), 4U);  // Bowl, Mug, Plate, Pot
  for (const auto& [name, times] : drawn) EXPECT_NEAR(times, 500, 100) << name;
}

TEST(SampleBinding, KeepsToWhatIsOffered) {
  const auto knowledge = small_home(Simulator::Ai2thor);
  const std::vector<std::string> offered = {"Mug", "Apple", "Table", "Fridge", "Shelf"};
  const auto& source = library_template("place-one-on");
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const auto binding = sample_binding(source, knowledge, offered, Rng(seed));
    ASSERT_TRUE(binding);
    for (const auto& [name, category] : *binding) {
      EXPECT_NE(std::find(offered.begin(), offered.end(), category), offered.end()) << category;
    }
  }
  EXPECT_FALSE(sample_binding(source, knowledge, {"Mug", "Fridge"}, Rng(1)));
}

/// A category with which the last placeholder cannot be filled is given up before those between are tried.
TEST(SampleBinding, FindsSoonTheOnlyFirstCategoryWithWhichTheLastCanBeFilled) {
  const auto reading = parse_template("three.template", R"((template three (name "put <A>, <B> and <C> on <D>")
    (split compositional) (parameters (A - pickupable) (B - pickupable) (C - pickupable) (D - furniture receptacle))
    (constraints (distinct A B C D) (fits-on A D) (fits-on B D) (fits-on C D))
    (init (exists (?a - A) (and)) (exists (?b - B) (and)) (exists (?c - C) (and))
      (forall (?a - A) (not (exists (?d - D) (on ?a ?d)))))
    (goal (exists (?d - D) (exists (?a - A) (exists (?b - B) (exists (?c - C)
      (at-end (and (on ?a ?d) (on ?b ?d) (on ?c ?d))))))))
    (instruction "Put {A:indefinite}, {B:indefinite} and {C:indefinite} {D:on}.")))");
  ASSERT_EQ(reading.templates.size(), 1U) << format(reading.errors.front());
  const auto& source = reading.templates.front();
  const auto knowledge = small_home(Simulator::Ai2thor);
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    int asked = 0;
    BindingWishes wishes;
    wishes.accepts = [&](const Binding& bound, const Parameter& parameter, const std::string&) {
      ++asked;
      return parameter.name != "D" || bound.front().second == "Pot";
    };
    const auto binding = sample_binding(source, knowledge, {}, wishes, Rng(seed));
    ASSERT_TRUE(binding);
    EXPECT_EQ(binding->front().second, "Pot");
    EXPECT_LT(asked, 200) << "all that three movable things and a place can be are 2970";
  }
}

TEST(SampleBinding, FillsARoomPlaceholderWithATypeOfRoom) {
  const auto reading = parse_template("bring.template", R"((template bring (name "bring <A> into <R>") (split atomic)
    (parameters (A - pickupable) (R - room))
    (init (forall (?a - A) (not (exists (?r - R) (in_room ?a ?r)))))
    (goal (exists (?a - A) (exists (?r - R) (at-end (in_room ?a ?r)))))
    (instruction "Bring {A:indefinite} {R:into}.")))");
  ASSERT_EQ(reading.templates.size(), 1U) << format(reading.errors.front());
  const auto knowledge = small_home(Simulator::Ai2thor);
  const auto binding = sample_binding(reading.templates[0], knowledge, {"Mug", "Table"}, Rng(3));
  ASSERT_TRUE(binding);
  EXPECT_EQ((*binding)[0].second, "Mug");
  EXPECT_TRUE((*binding)[1].second == "Kitchen" || (*binding)[1].second == "LivingRoom");
  EXPECT_TRUE(instantiate(reading.templates[0], knowledge, *binding));
}

}  // namespace
}  // namespace unietp
