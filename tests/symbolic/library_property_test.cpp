#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <iostream>
#include <map>

#include "generator/goal_parts.h"
#include "logic/evaluate.h"
#include "mutated_goals.h"
#include "naive_scene.h"
#include "symbolic/witness.h"
#include "templates/template.h"
#include "tests/generator/real_tables.h"

namespace unietp {
namespace {

/// Scenes a template; shared out over the simulators that it claims.
std::size_t scenes_wanted() {
  const char* wanted = std::getenv("UNIETP_PROPERTY_SCENES");
  return wanted == nullptr ? 8 : std::strtoul(wanted, nullptr, 10);
}

/// Only templates with this in their names.
bool is_wanted(const Template& source) {
  const char* part = std::getenv("UNIETP_PROPERTY_TEMPLATES");
  return part == nullptr || source.name.find(part) != std::string::npos;
}

constexpr std::size_t kScenesOfABinding = 4;

struct Tally {
  std::size_t scenes = 0, steps = 0;
  std::size_t undrawn = 0, unsolved = 0;  // no start, no plan within the budgets
  std::array<std::size_t, kMistakes> possible{}, made{}, forgiven{};
};

/// Everything that is asked of one template on one simulator.
class Trial {
 public:
  Trial(const Template& source, const Knowledge& knowledge, Tally& tally)
      : source_(source), knowledge_(knowledge), tally_(tally) {}

  void run(std::size_t scenes, Rng rng) {
    std::size_t done = 0;
    std::uint64_t refused = 0;  // by the gate: some, but not most
    for (std::uint64_t b = 0; done < scenes && failures_ < kMostFailures; ++b) {
      const auto binding = sample_binding(source_, knowledge_, {}, rng.fork("binding", b));
      ASSERT_TRUE(binding) << "no binding";
      const auto made = instantiate(source_, knowledge_, *binding);
      if (!made) {
        ASSERT_LE(++refused, 3 + b / 2) << format(made.error());
        continue;
      }
      const bool extended = source_.file.find("extended") != std::string::npos;
      const auto profile = extended ? ActionProfile::Wide : ActionProfile::Unietp;
      const NaiveScenes drawn(*made, knowledge_, rng.fork("bystanders", b), profile);
      mutations_ = mutated_goals(made->goal);
      for (std::size_t i = 0; i < kScenesOfABinding && done < scenes && failures_ < kMostFailures; ++i, ++done) {
        const auto scene = drawn.draw(rng.fork("scene", done));
        if (!scene) {
          ++tally_.undrawn;
        } else {
          look(*made, *scene, rng.fork("choice", done));
        }
      }
    }
  }

 private:
  static constexpr int kMostFailures = 2;

  void fail(const Specification& made, const std::string& what) {
    ++failures_;
    ADD_FAILURE() << what << "\n  " << to_text(made.goal);
  }

  std::string told(const NaiveScene& scene, const std::vector<symbolic::Step>& plan) const {
    std::string text = "\n  plan:";
    for (const auto& step : plan) text += " " + to_text(scene.setting, step);
    return text;
  }

  Trace trace_of_plan(const NaiveScene& scene, const std::vector<symbolic::Step>& plan) const {
    return trace_of(scene.setting, replay(scene.setting, scene.start, plan));
  }

  void look(const Specification& made, const NaiveScene& scene, Rng rng) {
    ++tally_.scenes;
    const auto start = trace_of(scene.setting, {scene.start});
    for (const auto& constraint : made.init) {
      if (!holds_in(constraint, start, 0)) return fail(made, "the random scene breaks " + to_text(constraint));
    }
    if (holds(made.goal, start)) return fail(made, "the goal holds at the start");
    for (const auto& part : goal_parts(made.goal)) {
      if (holds(part, start)) return fail(made, "a part of the goal holds at the start: " + to_text(part));
    }
    const auto plan = find_witness(made.goal, scene.setting, scene.start);
    if (!plan) {
      if (std::getenv("UNIETP_PROPERTY_TELL") != nullptr)
        std::cout << "no plan: " << source_.name << " " << to_text(made.goal) << described(scene) << "\n";
      ++tally_.unsolved;
      return;
    }
    tally_.steps += plan->size();
    if (!holds(made.goal, trace_of_plan(scene, *plan)))
      return fail(made, "the witness does not meet the goal" + told(scene, *plan));
    for (std::size_t length = 0; length < plan->size(); ++length) {
      const std::vector<symbolic::Step> prefix(plan->begin(), plan->begin() + static_cast<std::ptrdiff_t>(length));
      if (holds(made.goal, trace_of_plan(scene, prefix)))
        return fail(made, "the goal holds before the plan is done" + told(scene, prefix));
    }
    auto without = *plan;
    const auto left_out = rng.below(plan->size());
    without.erase(without.begin() + static_cast<std::ptrdiff_t>(left_out));
    if (holds(made.goal, trace_of_plan(scene, without)))
      return fail(made, "a step can be left out: " + to_text(scene.setting, (*plan)[left_out]) + told(scene, *plan));
    if (!mutations_.empty()) err(made, scene, mutations_[rng.below(mutations_.size())]);
  }

  /// Carries out a misunderstanding of the goal, as well as it can be done.
  void err(const Specification& made, const NaiveScene& scene, const MutatedGoal& mutation) {
    const auto kind = static_cast<std::size_t>(mutation.mistake);
    ++tally_.possible[kind];
    const auto plan = find_witness(mutation.goal, scene.setting, scene.start, {.most_worlds = 600});
    if (!plan) return;
    ++tally_.made[kind];
    if (!holds(made.goal, trace_of_plan(scene, *plan))) return;
    ++tally_.forgiven[kind];
    // It may come about by the way: a fridge cools what is put into it, a tap fills all that stands under it, what is
    // done again to another object was done first to one. A number that is missed is missed.
    if (mutation.mistake != Mistake::OneTooMany && mutation.mistake != Mistake::OneTooFew) return;
    fail(made, std::string(name_of(mutation.mistake)) + " is forgiven: " + to_text(mutation.goal) + told(scene, *plan));
  }

  std::string described(const NaiveScene& scene) const {
    std::string text = "\n  in:";
    for (std::size_t i = 0; i < scene.start.things.size(); ++i) {
      const auto& thing = scene.start.things[i];
      if (!thing.exists) continue;
      text += " " + scene.setting.cast.things[i].id;
      if (thing.where != symbolic::Where::Floor) text += "@" + name_of(scene.setting, thing.at);
    }
    return text;
  }

  const Template& source_;
  const Knowledge& knowledge_;
  Tally& tally_;
  std::vector<MutatedGoal> mutations_;
  int failures_ = 0;
};

std::vector<Template> both_libraries() {
  std::vector<Template> all;
  for (const char* folder : {"templates/library", "templates/extended"}) {
    auto read = load_templates(std::filesystem::path(UNIETP_SOURCE_DIR) / folder);
    for (const auto& error : read.errors) ADD_FAILURE() << format(error);
    for (auto& source : read.templates) all.push_back(std::move(source));
  }
  return all;
}

/// For every template and every simulator that it claims, on the real tables: nothing of the goal is done in a random
/// start, a plan exists, it is needed to its last step, and plans for misunderstandings of the goal fail.
TEST(Library, IsFalseAtTheStartReachableAndNotMetByMistakes) {
  const auto library = both_libraries();
  Tally all;
  std::array<std::size_t, kMistakes> templates_with{}, templates_made{}, templates_caught{};
  std::size_t templates = 0;
  for (const auto& source : library) {
    if (!is_wanted(source)) continue;
    SCOPED_TRACE(source.name);
    Tally tally;
    for (std::size_t s = 0; s < source.simulators.size(); ++s) {
      SCOPED_TRACE(name_of(source.simulators[s]));
      const std::size_t share = (scenes_wanted() + source.simulators.size() - 1) / source.simulators.size();
      Trial(source, real_tables(source.simulators[s]), tally).run(share, Rng(4).fork(source.name, s));
    }
    EXPECT_GE(2 * tally.scenes, scenes_wanted());
    EXPECT_LE(2 * tally.unsolved, tally.scenes);
    all.undrawn += tally.undrawn;
    all.unsolved += tally.unsolved;
    ++templates;
    all.scenes += tally.scenes;
    all.steps += tally.steps;
    for (std::size_t kind = 0; kind < kMistakes; ++kind) {
      all.made[kind] += tally.made[kind];
      all.forgiven[kind] += tally.forgiven[kind];
      templates_with[kind] += tally.possible[kind] > 0 ? 1 : 0;
      templates_made[kind] += tally.made[kind] > 0 ? 1 : 0;
      templates_caught[kind] += tally.made[kind] > tally.forgiven[kind] ? 1 : 0;
    }
  }
  std::cout << templates << " templates, " << all.scenes << " scenes, " << all.steps
            << " steps of witnesses; no start drawn " << all.undrawn << " times, no plan found " << all.unsolved
            << " times\n";
  for (std::size_t kind = 0; kind < kMistakes; ++kind) {
    std::cout << name_of(static_cast<Mistake>(kind)) << ": possible for " << templates_with[kind]
              << " templates, made for " << templates_made[kind] << " in " << all.made[kind] << " scenes, forgiven in "
              << all.forgiven[kind] << "\n";
    EXPECT_GE(10 * templates_made[kind], 6 * templates_with[kind]) << name_of(static_cast<Mistake>(kind));
    EXPECT_GE(10 * templates_caught[kind], 8 * templates_made[kind]) << name_of(static_cast<Mistake>(kind));
    EXPECT_LE(5 * all.forgiven[kind], 2 * all.made[kind]) << name_of(static_cast<Mistake>(kind));
  }
  if (std::getenv("UNIETP_PROPERTY_TEMPLATES") != nullptr) return;
  EXPECT_GE(templates_made[static_cast<std::size_t>(Mistake::WrongOrder)], 8U);
  EXPECT_GE(templates_made[static_cast<std::size_t>(Mistake::OneTooMany)], 4U);
  EXPECT_GE(templates_made[static_cast<std::size_t>(Mistake::PartLeftOut)], 25U);
}

}  // namespace
}  // namespace unietp
