#include "exports/virtualhome_program.h"

#include <algorithm>
#include <array>
#include <set>
#include <string_view>

#include "scene/action.h"
#include "scene/trace.h"

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
  Programmer(const Scene& start, const std::map<std::string, std::string>& names) : names_(names), now_(start) {
    for (const Node& node : start.nodes) {
      if (node.states.has(Predicate::Unplugged)) unplugged_.insert(node.id);
    }
  }

  Result<std::vector<std::string>> run(const DemonstrationRecord& demonstration) {
    for (const StepRecord& step : demonstration.steps) {
      const auto type = action_named(step.command.action);
      if (!step.success || type == ActionType::Stop) continue;
      if (auto added = add(step, type); !added) return added.error();
      now_ = apply(std::move(now_), step.changes);
    }
    return std::move(lines_);
  }

 private:
  using Words = std::vector<std::string>;
  /// What rests on or in a thing, as the edges that say so.
  using Load = std::vector<Edge>;

  Result<Done> add(const StepRecord& step, std::optional<ActionType> type) {
    const auto* const known = std::find_if(kProgramActions.begin(), kProgramActions.end(),
                                           [&](const ProgramAction& action) { return action.type == type; });
    if (known == kProgramActions.end()) return not_expressed("VirtualHome has no action " + step.command.action);
    std::vector<std::string> objects;
    if (known->held_first) objects = now_.agent.held;
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
    if (auto acted = line(known->word, objects); !acted) return acted;
    std::set<std::string> again;
    if (type == ActionType::PickUp) return load_again(objects.front(), load_of(objects.front()), true, again);
    if (known->held_first && objects.size() > 1) {
      // A walk makes the graph forget what is in the thing in the hand, and nothing of what is on it.
      Load inside = load_of(objects.front());
      std::erase_if(inside, [](const Edge& edge) { return edge.relation != Predicate::Inside; });
      return load_again(objects.front(), inside, false, again);
    }
    return Done{};
  }

  Load load_of(const std::string& thing) const {
    Load load;
    for (const Edge& edge : now_.edges) {
      if (edge.to == thing && (edge.relation == Predicate::On || edge.relation == Predicate::Inside))
        load.push_back(edge);
    }
    std::erase_if(load, [&](const Edge& edge) {  // in the thing by being on or in another that is in it
      return std::any_of(load.begin(), load.end(), [&](const Edge& below) {
        return std::any_of(now_.edges.begin(), now_.edges.end(), [&](const Edge& one) {
          return one.from == edge.from && one.to == below.from &&
                 (one.relation == Predicate::On || one.relation == Predicate::Inside);
        });
      });
    });
    return load;
  }

  /// The lines that take up what was on or in a thing when it was grabbed, and put it there again: `Grab` forgets it,
  /// and what is on or in that in turn. `again`: things that have their lines; in a home two may rest on each other.
  Result<Done> load_again(const std::string& thing, const Load& load, bool in_hand, std::set<std::string>& again) {
    const Node* const node = find_node(now_, thing);
    const bool shut =
        node != nullptr && node->states.has(Predicate::Closed) &&
        std::any_of(load.begin(), load.end(), [](const Edge& edge) { return edge.relation == Predicate::Inside; });
    if (shut) {
      if (auto opened = line("Open", {thing}); !opened) return opened;
    }
    again.insert(thing);
    for (const Edge& edge : load) {
      if (!again.insert(edge.from).second) continue;
      std::vector<std::pair<std::string_view, Words>> lines{{"Walk", {edge.from}}, {"Grab", {edge.from}}};
      if (!in_hand) lines.emplace_back("Walk", Words{thing});
      lines.emplace_back(edge.relation == Predicate::On ? "PutBack" : "PutIn", Words{edge.from, thing});
      for (const auto& [word, objects] : lines) {
        if (auto written = line(word, objects); !written) return written;
        if (word == "Walk") walked_to_ = objects.front();
      }
      if (auto more = load_again(edge.from, load_of(edge.from), false, again); !more) return more;
    }
    return shut ? line("Close", {thing}) : Done{};
  }

  bool is_held(const std::string& object) const {
    return std::find(now_.agent.held.begin(), now_.agent.held.end(), object) != now_.agent.held.end();
  }

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
  Scene now_;  // before the step
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
