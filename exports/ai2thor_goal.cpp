#include "exports/ai2thor_goal.h"

#include <algorithm>

#include "exports/ai2thor_words.h"
#include "exports/ltlf_formula.h"
#include "interchange/formats.h"
#include "logic/evaluate.h"
#include "scene/trace.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

/// A proposition about AI2-THOR's metadata.
class TestWriter {
 public:
  TestWriter(const Scene& start, const ThorNames& names, const Knowledge& knowledge)
      : start_(start), names_(names), knowledge_(knowledge) {}

  Result<Json> test_of(const LtlfProposition& one, const Facts& at_start) const {
    const std::string& first = one.arguments.front();
    if (one.meaning == Predicate::InRoom) return in_room(first, one.arguments[1]);
    const auto name = names_.find(first);
    if (name == names_.end()) return thor_lacks(first + " is not in the house");
    switch (one.meaning) {
      case Predicate::Colour:
      case Predicate::Material:
      case Predicate::Size:
        return Json{{"always", one.holds_in(at_start)}};
      case Predicate::On:
      case Predicate::Inside:
        return on_or_inside(name->second, one);
      case Predicate::OnFloor: {
        auto room = in_room(first, one.arguments[1]);
        if (!room) return room;
        return Json{{"all",
                     {Json{{"objectId", name->second}, {"key", "parentReceptacles"}, {"containsType", "Floor"}},
                      std::move(*room)}}};
      }
      default:
        break;
    }
    const Node* const node = find_node(start_, first);
    const bool of_switch = one.meaning == Predicate::PowerOn || one.meaning == Predicate::PowerOff;
    const auto test = thor_test({one.meaning, one.arguments.size() > 1 ? one.arguments[1] : ""}, name->second);
    if (!test || (of_switch && node != nullptr && !thor_holding_part(node->category).empty()))
      return thor_lacks("AI2-THOR's metadata does not tell " + one.predicate +
                        (node == nullptr ? std::string() : " of " + node->category));
    return *test;
  }

 private:
  Result<Json> in_room(const std::string& what, const std::string& room) const {
    const auto place =
        std::find_if(start_.rooms.begin(), start_.rooms.end(), [&](const Room& one) { return one.id == room; });
    if (place == start_.rooms.end()) return thor_lacks("there is no room " + room);
    const std::string id = procthor_room_id(static_cast<std::size_t>(place - start_.rooms.begin()));
    if (what == "agent") return Json{{"agent", true}, {"room", id}};
    const auto name = names_.find(what);
    if (name == names_.end()) return thor_lacks(what + " is not in the house");
    return Json{{"objectId", name->second}, {"room", id}};
  }

  Result<Json> on_or_inside(const std::string& object, const LtlfProposition& one) const {
    const auto place = names_.find(one.arguments[1]);
    if (place == names_.end()) return thor_lacks(one.arguments[1] + " is not in the house");
    Json test{{"objectId", object}, {"key", "parentReceptacles"}, {"contains", place->second}};
    // The metadata does not tell on from inside; where things go both ways, heights do.
    const Node* const node = find_node(start_, one.arguments[1]);
    const bool both =
        node != nullptr && knowledge_.has(node->category, "container") && knowledge_.has(node->category, "receptacle");
    if (both) test["above"] = one.meaning == Predicate::On;
    return test;
  }

  const Scene& start_;
  const ThorNames& names_;
  const Knowledge& knowledge_;
};

}  // namespace

Result<ThorGoal> thor_goal(const FinishedTask& task, const ThorNames& names, const Knowledge& knowledge) {
  const Formula& goal = task.record.goal_tree;
  if (ranges_over_later_pieces(goal, task.start, knowledge))
    return thor_lacks("its goal ranges over pieces that do not exist at the start");
  std::vector<Delta> changes;
  for (const auto& step : task.shown.at(Mode::M1).steps) changes.push_back(step.changes);
  const bool with_comparisons = reads_comparisons(goal);
  const Trace start = to_logic(task.start, {}, with_comparisons);
  const Trace trace = to_logic(task.start, changes, with_comparisons);
  if (holds(goal, start)) return thor_lacks("among what is in the house its goal holds at the start");
  if (!holds(goal, trace)) return thor_lacks("among what is in the house the demonstration does not reach its goal");
  auto ltlf = ltlf_goal(goal, start);
  if (!ltlf) return ltlf.error();
  ThorGoal made;
  made.formula = std::move(ltlf->formula);
  made.propositions = Json::array();
  const TestWriter tests(task.start, names, knowledge);
  for (const auto& one : ltlf->propositions) {
    const auto test = tests.test_of(one, trace.states.front());
    if (!test) return test.error();
    made.propositions.push_back(
        {{"name", one.name}, {"predicate", one.predicate}, {"arguments", one.arguments}, {"test", *test}});
    for (const auto& argument : one.arguments) {
      if (names.contains(argument)) made.objects.insert(argument);
    }
  }
  for (const Facts& facts : trace.states) {
    made.holding.push_back(Json::array());
    for (const auto& one : ltlf->propositions) {
      if (one.holds_in(facts)) made.holding.back().push_back(one.name);
    }
  }
  return made;
}

}  // namespace unietp
