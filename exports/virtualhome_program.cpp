#include "exports/virtualhome_program.h"

#include <algorithm>
#include <array>
#include <set>
#include <string_view>

#include "scene/action.h"

namespace unietp {
namespace {

/// VirtualHome's words for the actions of its tasks. Source: the actions of the package `virtualhome` 2.3.0.
struct ProgramAction {
  ActionType type;
  std::string_view word;
  bool held_first = false;  // names what the hand holds before the argument
};
constexpr std::array kProgramActions{ProgramAction{ActionType::GoTo, "Walk"},
                                     ProgramAction{ActionType::TurnTo, "TurnTo"},
                                     ProgramAction{ActionType::PickUp, "Grab"},
                                     ProgramAction{ActionType::PlaceOn, "PutBack", true},
                                     ProgramAction{ActionType::PlaceIn, "PutIn", true},
                                     ProgramAction{ActionType::Open, "Open"},
                                     ProgramAction{ActionType::Close, "Close"},
                                     ProgramAction{ActionType::TurnOn, "SwitchOn"},
                                     ProgramAction{ActionType::TurnOff, "SwitchOff"},
                                     ProgramAction{ActionType::SitOn, "Sit"},
                                     ProgramAction{ActionType::LieOn, "Lie"},
                                     ProgramAction{ActionType::StandUp, "StandUp"},
                                     ProgramAction{ActionType::PlugIn, "PlugIn"},
                                     ProgramAction{ActionType::Unplug, "PlugOut"},
                                     ProgramAction{ActionType::Read, "Read"}};

Error not_expressed(std::string why) { return {Error::Kind::Unsatisfiable, "", {}, std::move(why)}; }

class Programmer {
 public:
  Programmer(const Scene& start, const std::map<std::string, std::string>& names) : names_(names) {
    held_ = start.agent.held;
    for (const Node& node : start.nodes) {
      if (node.states.has(Predicate::Unplugged)) unplugged_.insert(node.id);
    }
  }

  Result<std::vector<std::string>> run(const DemonstrationRecord& demonstration) {
    for (const StepRecord& step : demonstration.steps) {
      const auto type = action_named(step.command.action);
      if (!step.success || type == ActionType::Stop) continue;
      if (auto added = add(step, type); !added) return added.error();
      if (step.changes.agent) held_ = step.changes.agent->held;
    }
    return std::move(lines_);
  }

 private:
  Result<Done> add(const StepRecord& step, std::optional<ActionType> type) {
    const auto* const known = std::find_if(kProgramActions.begin(), kProgramActions.end(),
                                           [&](const ProgramAction& action) { return action.type == type; });
    if (known == kProgramActions.end()) return not_expressed("VirtualHome has no action " + step.command.action);
    std::vector<std::string> objects;
    if (known->held_first) objects.insert(objects.end(), held_.begin(), held_.end());
    for (const Argument& argument : step.command.args) objects.push_back(argument.id);
    if (type == ActionType::GoTo) {
      walked_to_ = objects.front();
    } else if (!objects.empty() && objects.back() != walked_to_ && !is_held(objects.back())) {
      walked_to_ = objects.back();
      if (auto walked = line("Walk", {walked_to_}); !walked) return walked.error();
    }
    if (type == ActionType::TurnOn && unplugged_.contains(objects.front())) {
      if (auto plugged = line("PlugIn", objects); !plugged) return plugged.error();
    }
    if (type == ActionType::TurnOn || type == ActionType::PlugIn) unplugged_.erase(objects.front());
    if (type == ActionType::Unplug) unplugged_.insert(objects.front());
    return line(known->word, objects);
  }

  bool is_held(const std::string& object) const { return std::find(held_.begin(), held_.end(), object) != held_.end(); }

  Result<Done> line(std::string_view word, const std::vector<std::string>& objects) {
    std::string text = "[" + std::string(word) + "]";
    for (const std::string& object : objects) {
      const auto name = names_.find(object);
      if (name == names_.end()) return not_expressed(object + " is not in the graph");
      const auto end = name->second.rfind('_');
      text += " <" + name->second.substr(0, end) + "> (" + name->second.substr(end + 1) + ")";
    }
    lines_.push_back(text);
    return Done{};
  }

  const std::map<std::string, std::string>& names_;
  std::vector<std::string> held_;
  std::set<std::string> unplugged_;
  std::string walked_to_;  // the last that the agent walked to; "" for none
  std::vector<std::string> lines_;
};

}  // namespace

Result<std::vector<std::string>> virtualhome_program(const DemonstrationRecord& demonstration, const Scene& start,
                                                     const std::map<std::string, std::string>& names) {
  return Programmer(start, names).run(demonstration);
}

}  // namespace unietp
