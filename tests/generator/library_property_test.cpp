#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <iostream>
#include <map>

#include "generator/goal_parts.h"
#include "logic/evaluate.h"
#include "symbolic/witness.h"
#include "templates/template.h"
#include "tests/generator/mutated_goals.h"
#include "tests/generator/naive_scene.h"
#include "tests/support/committed_knowledge.h"

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
  std::size_t scenes = 0, steps = 0, undrawn = 0, long_searches = 0;
  /// Of each mistake: scenes in which it was tried, carried out, carried out only when the goal was kept from coming
  /// about by the way, and those in which it was not carried out without meeting the goal.
  std::array<std::size_t, kMistakes> tried{}, made{}, by_the_way{}, none{};
};

/// Mistakes that nobody can make: a dry cloth takes no dirt off, so what is soaked too late was not what cleaned, and
/// another one that was soaked in time is as good. Who opens nothing has left the wrong machine shut and the right one
/// too.
bool cannot_be_made(const Specification& made, Mistake mistake) {
  return (mistake == Mistake::Decoy && made.template_name == "place-never-open") ||
         (mistake == Mistake::WrongOrder && made.template_name == "soak-then-clean");
}

/// Everything that is asked of one template on one simulator.
class Trial {
 public:
  Trial(const Template& source, const Knowledge& knowledge, Tally& tally)
      : source_(source), knowledge_(knowledge), tally_(tally) {}

  void run(std::size_t scenes, Rng rng) {
    std::size_t done = 0;
    std::uint64_t refused = 0, undrawn = 0;  // by the gate, and within the blind budget: some, but not most
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
      for (std::size_t i = 0; i < kScenesOfABinding && done < scenes && failures_ < kMostFailures; ++i) {
        const auto scene = drawn.draw(rng.fork("scene", kScenesOfABinding * b + i));
        if (!scene) {
          ASSERT_LE(++undrawn, 20 + done) << "hardly any start can be drawn";
          continue;
        }
        look(*made, *scene, rng.fork("choice", done));
        ++done;
      }
    }
    tally_.undrawn += undrawn;
  }

 private:
  static constexpr int kMostFailures = 2;

  void fail(const Specification& made, const NaiveScene& scene, const std::string& what,
            const std::vector<symbolic::Step>& plan = {}) {
    ++failures_;
    std::string text = what + "\n  " + to_text(made.goal) + "\n  in:" + described(scene) + "\n  plan:";
    for (const auto& step : plan) text += " " + to_text(scene.setting, step);
    ADD_FAILURE() << text;
  }

  static Trace trace_of_plan(const NaiveScene& scene, const std::vector<symbolic::Step>& plan) {
    return trace_of(scene.setting, replay(scene.setting, scene.start, plan));
  }

  void look(const Specification& made, const NaiveScene& scene, Rng rng) {
    ++tally_.scenes;
    const auto start = trace_of(scene.setting, {scene.start});
    for (const auto& constraint : made.init) {
      if (!holds_in(constraint, start, 0)) return fail(made, scene, "the random scene breaks " + to_text(constraint));
    }
    if (holds(made.goal, start)) return fail(made, scene, "the goal holds at the start");
    for (const auto& part : goal_parts(made.goal)) {
      if (holds(part, start)) return fail(made, scene, "a part of the goal holds at the start: " + to_text(part));
    }
    auto plan = find_witness(made.goal, scene.setting, scene.start);
    if (!plan) {  // a crowded scene may want a longer search
      ++tally_.long_searches;
      plan = find_witness(made.goal, scene.setting, scene.start, {.most_worlds = 100000, .most_steps = 200});
    }
    if (!plan) return fail(made, scene, "no plan was found");
    tally_.steps += plan->size();
    if (!holds(made.goal, trace_of_plan(scene, *plan)))
      return fail(made, scene, "the witness does not meet the goal", *plan);
    for (auto end = plan->end(); end != plan->begin();) {
      --end;
      if (holds(made.goal, trace_of_plan(scene, {plan->begin(), end})))
        return fail(made, scene, "the goal holds before the plan is done", *plan);
    }
    auto without = *plan;
    const auto left_out = rng.below(plan->size());
    without.erase(without.begin() + static_cast<std::ptrdiff_t>(left_out));
    if (holds(made.goal, trace_of_plan(scene, without)))
      return fail(made, scene, "a step can be left out: " + to_text(scene.setting, (*plan)[left_out]), *plan);
    if (!mutations_.empty()) err(made, scene, mutations_[rng.below(mutations_.size())]);
  }

  /// Carries out a misunderstanding of the goal, as well as it can be done. The goal itself may come about by the way
  /// (a tap fills all that stands under it, what is done again to another object was done first to one): then that is
  /// no mistake, and one is looked for that keeps the goal from coming about.
  void err(const Specification& made, const NaiveScene& scene, const MutatedGoal& mutation) {
    const auto kind = static_cast<std::size_t>(mutation.mistake);
    ++tally_.tried[kind];
    auto plan = find_witness(mutation.goal, scene.setting, scene.start, {.most_worlds = 600});
    if (!plan) return;
    if (holds(made.goal, trace_of_plan(scene, *plan))) {
      if (misses_a_number(mutation.mistake))
        return fail(made, scene, std::string(name_of(mutation.mistake)) + " is forgiven", *plan);
      if (mutation.mistake == Mistake::PartLeftOut) {
        ++tally_.none[kind];
        return;
      }
      plan = find_witness(conjunction({mutation.goal, negation(made.goal)}), scene.setting, scene.start);
      ++(plan ? tally_.by_the_way : tally_.none)[kind];
      if (!plan && !cannot_be_made(made, mutation.mistake))
        return fail(made, scene, std::string(name_of(mutation.mistake)) + " cannot be told from the goal");
      if (!plan) return;
      if (holds(made.goal, trace_of_plan(scene, *plan)))
        return fail(made, scene, std::string(name_of(mutation.mistake)) + " is forgiven", *plan);
    }
    ++tally_.made[kind];
  }

  /// These contradict the goal, so that nothing can be fulfilled by the way.
  static bool misses_a_number(Mistake mistake) {
    return mistake == Mistake::OneTooMany || mistake == Mistake::OneTooFew;
  }

  static std::string described(const NaiveScene& scene) {
    std::string text;
    for (std::size_t i = 0; i < scene.start.things.size(); ++i) {
      const auto& thing = scene.start.things[i];
      if (!thing.exists) continue;
      text += " " + scene.setting.objects.things[i].id;
      if (thing.where == symbolic::PlaceKind::On) text += " on " + name_of(scene.setting, thing.at);
      if (thing.where == symbolic::PlaceKind::Inside) text += " in " + name_of(scene.setting, thing.at);
      for (const auto& predicate : all_predicates()) {
        if (thing.has(predicate.predicate)) text += " " + std::string(predicate.name);
      }
      text += ",";
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

void add_up(Tally& all, const Tally& tally) {
  all.scenes += tally.scenes;
  all.steps += tally.steps;
  all.undrawn += tally.undrawn;
  all.long_searches += tally.long_searches;
  for (std::size_t kind = 0; kind < kMistakes; ++kind) {
    all.tried[kind] += tally.tried[kind];
    all.made[kind] += tally.made[kind];
    all.by_the_way[kind] += tally.by_the_way[kind];
    all.none[kind] += tally.none[kind];
  }
}

/// For every template and every simulator that it claims, on the real tables: nothing of the goal is done in a random
/// start, a plan exists, it is needed to its last step, and plans for misunderstandings of the goal fail.
TEST(Library, IsFalseAtTheStartReachableAndNotMetByMistakes) {
  const auto library = both_libraries();
  Tally all;
  std::array<std::size_t, kMistakes> templates_with{}, templates_made{};
  std::size_t templates = 0;
  for (const auto& source : library) {
    if (!is_wanted(source)) continue;
    SCOPED_TRACE(source.name);
    Tally tally;
    for (std::size_t s = 0; s < source.simulators.size(); ++s) {
      SCOPED_TRACE(name_of(source.simulators[s]));
      const std::size_t share = (scenes_wanted() + source.simulators.size() - 1) / source.simulators.size();
      Trial(source, committed_knowledge(source.simulators[s]), tally).run(share, Rng(4).fork(source.name, s));
    }
    EXPECT_GE(tally.scenes, scenes_wanted());
    ++templates;
    add_up(all, tally);
    for (std::size_t kind = 0; kind < kMistakes; ++kind) {
      templates_with[kind] += tally.tried[kind] > 0 ? 1 : 0;
      templates_made[kind] += tally.made[kind] > 0 ? 1 : 0;
      const bool tell = kind != static_cast<std::size_t>(Mistake::PartLeftOut) &&
                        std::getenv("UNIETP_PROPERTY_TELL") != nullptr && tally.tried[kind] > 0 &&
                        (tally.made[kind] == 0 || tally.none[kind] > 0);
      if (tell) {
        std::cout << source.name << ", " << name_of(static_cast<Mistake>(kind)) << ": tried " << tally.tried[kind]
                  << ", made " << tally.made[kind] << ", the same as the goal " << tally.none[kind] << "\n";
      }
    }
  }
  std::cout << templates << " templates, " << all.scenes << " scenes, " << all.steps
            << " steps of witnesses; no start drawn " << all.undrawn << " times, a longer search in "
            << all.long_searches << " scenes\n";
  for (std::size_t kind = 0; kind < kMistakes; ++kind) {
    std::cout << name_of(static_cast<Mistake>(kind)) << ": possible for " << templates_with[kind]
              << " templates, made for " << templates_made[kind] << " in " << all.made[kind] << " of "
              << all.tried[kind] << " scenes, kept from the goal on the way in " << all.by_the_way[kind]
              << "; cannot be told from the goal in " << all.none[kind] << "\n";
  }
}

}  // namespace
}  // namespace unietp
