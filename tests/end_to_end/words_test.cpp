// In M2 and M3 an agent is told in no words of things that its mode has not shown it.
#include <algorithm>
#include <cstdlib>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/text.h"
#include "environment/observation_json.h"
#include "task_sources.h"
#include "tests/environment/random_agent.h"
#include "tests/support/committed_knowledge.h"

namespace unietp {
namespace {

/// Lower case, words apart by one space, with one before and behind.
std::string plain(const std::string& text) {
  std::string words = " ";
  for (const char c : lower(text)) {
    const bool is_letter = std::isalnum(static_cast<unsigned char>(c)) != 0;
    if (is_letter || words.back() != ' ') words += is_letter ? c : ' ';
  }
  return words.back() == ' ' ? words : words + ' ';
}

/// What feedback calls a category.
std::string called(Simulator simulator, const std::string& category) {
  const Category* known = committed_knowledge(simulator).find(category);
  return plain(known == nullptr ? category : known->display);
}

/// The words of sentences that no task has a part in.
std::set<std::string> common_words() {
  std::string all = "Could not use";
  for (std::size_t i = 0; i < kFailureCauseCount; ++i) {
    const FailureCauseInfo& cause = info(static_cast<FailureCause>(i));
    all += " " + std::string(cause.sentence) + " " + std::string(name_of(cause.failure));
  }
  for (const auto list : {all_actions(), extension_actions()}) {
    for (const ActionInfo& action : list) all += " " + replace_all(std::string(action.name), "_", " ");
  }
  std::set<std::string> words;
  for (const auto& word : split(plain(all), ' ')) words.emplace(word);
  return words;
}

/// What an agent has been shown, and what it has not, by the names of categories.
class Shown {
 public:
  Shown(const Environment& start, Mode mode) : simulator_(start.task()->simulator), scene_(start.task()->start) {
    for (const Node& node : scene_.nodes) {
      if (mode == Mode::M2 && !node.movable) show(node.category);
    }
    for (const Room& room : scene_.rooms) known_.insert(plain(room.type));
    told_ = plain(start.observe().instruction);
    look(start);
  }

  /// Everything in the picture, and in the hand.
  void look(const Environment& now) {
    std::set<std::string> ids;
    for (const VisibleObject& object : now.pictured()) {
      ids.insert(object.id);
      known_.insert(plain(object.id));  // "egg_cracked_16" names no egg
    }
    const Observation& seen = now.observe();
    for (const HeldObject& held : seen.held.value_or(std::vector<HeldObject>())) show(held.category);
    for (const Node& node : now.scene().nodes) {
      if (ids.contains(node.id)) show(node.category);
    }
  }

  /// A name of something that was not shown in what is told; "" for none.
  std::string named_in(const std::string& told) const {
    std::string text = plain(told);
    std::vector<std::string> known(known_.begin(), known_.end());
    std::sort(known.begin(), known.end(), [](const auto& a, const auto& b) { return a.size() > b.size(); });
    for (const std::string& name : known) text = replace_all(text, name, " ");
    for (const auto& name : not_shown()) {
      if (text.find(name) != std::string::npos) return name;
    }
    return "";
  }

  /// Names of what is in the home and was not shown, but for words that are told anyhow.
  std::set<std::string> not_shown() const {
    static const std::set<std::string> kCommon = common_words();
    std::set<std::string> names;
    for (const Node& node : scene_.nodes) {
      const std::string name = called(simulator_, node.category);
      const bool is_common = kCommon.contains(std::string(trim(name))) || told_.find(name) != std::string::npos;
      if (!is_common && !known_.contains(name)) names.insert(name);
    }
    return names;
  }

 private:
  void show(const std::string& category) {
    known_.insert(called(simulator_, category));
    known_.insert(plain(category));
  }

  Simulator simulator_;
  const Scene& scene_;
  std::set<std::string> known_;
  std::string told_;  // the instruction
};

TEST(EnvironmentsOfADataSet, NameNothingInM2AndM3ThatTheyHaveNotShown) {
  const TaskSource tasks = source();
  const char* given = std::getenv("UNIETP_EPISODES");
  const std::size_t count = given == nullptr ? 32 : std::strtoul(given, nullptr, 10);
  std::size_t steps = 0, names = 0;
  for (std::size_t episode = 0; episode < count; ++episode) {
    const Mode mode = episode % 2 == 0 ? Mode::M2 : Mode::M3;
    Environment environment = environment_of(tasks, (episode / 2) % tasks.size(), mode);
    Shown shown(environment, mode);
    names += shown.not_shown().size();
    ASSERT_EQ(shown.named_in(environment.prompt().substr(environment.prompt().find("What you know"))), "");
    testing::RandomAgent agent(Rng(23).fork("episode", episode));
    while (!environment.over()) {
      const StepResult step = environment.step(agent.answer(environment));
      ++steps;
      shown.look(environment);
      std::string told = observation_to_json(step.observation, environment.settings()).dump() + environment.text();
      ASSERT_EQ(shown.named_in(told), "") << environment.task()->text.id << " in " << name_of(mode) << ", step "
                                          << step.observation.step << ": " << told;
    }
  }
  EXPECT_GT(names, 20 * count) << "there is much that must not be told";
  std::printf("%zu episodes, %zu answers, %zu names of what was not shown at the start\n", count, steps, names);
}

}  // namespace
}  // namespace unietp
