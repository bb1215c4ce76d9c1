#include "pddl/plan.h"

#include "pddl/domain.h"

namespace unietp::pddl {
namespace {

using symbolic::Id;
using symbolic::kNobody;
using symbolic::Step;
using symbolic::World;

class StepWriter {
 public:
  StepWriter(const symbolic::Setting& setting, const Problem& problem, const World& world)
      : setting_(setting), problem_(problem), world_(world) {}

  std::string write(const Step& step) const {
    const auto word = std::string(info(step.action).name);
    const auto at = [&] { return " " + name(step.target); };
    const auto held = [&] { return " " + name(world_.held); };
    const bool in_hand = step.target != kNobody && world_.held == step.target;
    auto on_target = "(" + word + (in_hand ? "-held" : "") + (step.target == kNobody ? "" : at()) + ")";
    switch (step.action) {
      case ActionType::GoTo: {
        if (step.target.is_room()) return "(" + word + "-room" + at() + ")";
        const Id root = root_of(world_, step.target);
        return "(" + word + " " + name(root) + " " + name(world_[root].at) + ")";
      }
      case ActionType::Open:
        return "(" + word + "-shut" + at() + ")";
      case ActionType::PlaceOn:
      case ActionType::PlaceIn:
      case ActionType::Slice:
        return "(" + word + held() + at() + ")";
      case ActionType::Drop:
        return "(" + word + held() + " " + name(world_.room) + ")";
      case ActionType::TurnOn: {
        const bool shuts =
            setting_.kind_of(step.target).shuts_to_run && setting_.rules->capabilities().power_needs_closed;
        return shuts ? "(" + word + "-shut" + at() + ")" : on_target;
      }
      case ActionType::PourTo: {
        const bool away = setting_.kind_of(step.target).drain || reaction(step.target, Treatment::Drains) != nullptr;
        return "(" + word + (away ? "-away" : "") + held() + at() + " " +
               problem_.substances[world_[world_.held].filling.index()] + ")";
      }
      case ActionType::Wipe:
        return "(" + word + (world_[world_.held].has(Predicate::Dry) ? "-dry" : "") + held() + at() + ")";
      case ActionType::SpreadTo: {
        const auto* spread = setting_.rules->reaction(setting_.kind_number(world_.held), Treatment::Dispenses,
                                                      setting_.kind_number(step.target));
        return "(" + word + held() + at() + " " + problem_.substances[spread->symbol.index()] + ")";
      }
      default:
        break;
    }
    for (std::size_t t = 0; t < kTreatments; ++t) {
      const auto treatment = static_cast<Treatment>(t);
      if (action_for(treatment) != step.action) continue;
      const auto* own = reaction(step.target, treatment);
      if (own == nullptr) continue;
      const bool fills = treatment == Treatment::Fills;
      return "(" + composite_name(*class_of(setting_, step.target, *own)) + held() + at() +
             (fills ? " " + problem_.substances[own->symbol.index()] : "") + ")";
    }
    return on_target;
  }

 private:
  const symbolic::Reaction* reaction(Id tool, Treatment treatment) const {
    return setting_.rules->reaction(setting_.kind_number(tool), treatment, setting_.kind_number(world_.held));
  }
  const std::string& name(Id id) const {
    return id.is_room() ? problem_.rooms[id.index()] : problem_.things[id.index()];
  }

  const symbolic::Setting& setting_;
  const Problem& problem_;
  const World& world_;
};

bool is_of_body(ActionType action) {
  return action <= ActionType::RotateHand || action == ActionType::TurnTo || action == ActionType::Stop;
}

class PlanWriter {
 public:
  PlanWriter(const symbolic::Setting& setting, const World& start, const symbolic::Goal& goal, const Problem& problem,
             const std::vector<std::pair<std::string, std::string>>& pieces)
      : setting_(setting), start_(start), goal_(goal), problem_(problem), pieces_(pieces), world_(start) {}

  Result<std::vector<std::string>> write(const std::vector<Action>& actions) {
    for (const auto& action : actions) {
      if (is_of_body(action.type)) continue;
      const Id target = action.args.empty() ? kNobody : id_of(action.args.front());
      if (!action.args.empty() && target == kNobody) return refused(action, Failure::InvalidArgument);
      const Step step{action.type, target};
      auto trial = world_;
      if (perform(setting_, trial, step) == Failure::TooFar) (void)take({ActionType::GoTo, target});
      if (const Failure failure = take(step); failure != Failure::None) return refused(action, failure);
    }
    if (!reaches_goal(steps_))
      return Error{Error::Kind::Unsatisfiable, "plan", {}, "reaches the goal in physics, but not in symbols"};
    leave_out_needless();
    return lines();
  }

 private:
  static Error refused(const Action& action, Failure failure) {
    return {Error::Kind::Unsatisfiable,
            "plan",
            {},
            "the symbols do not allow " + to_text(action) + ": " + std::string(name_of(failure))};
  }

  Failure take(const Step& step) {
    // What is not there yet, such as a piece before the cut, and what is in the hand stands in no room.
    if (step.action == ActionType::GoTo && step.target.is_thing() && !world_[root_of(world_, step.target)].at.is_room())
      return Failure::InvalidArgument;
    auto trial = world_;
    if (const Failure failure = perform(setting_, trial, step); failure != Failure::None) return failure;
    for (const Step& one : written_as(setting_, problem_, world_, step)) {
      if (const Failure failure = perform(setting_, world_, one); failure != Failure::None) return failure;
      steps_.push_back(one);
    }
    return Failure::None;
  }

  bool reaches_goal(const std::vector<Step>& steps) const {
    World world = start_;
    symbolic::Progress progress(goal_);
    progress.observe(goal_, setting_, world);
    for (const Step& step : steps)
      if (progress.perform(goal_, setting_, world, step) != Failure::None) return false;
    return holds(goal_, goal_.root(), setting_, world, progress);
  }

  /// What only physics needs: a door closed because it stands in the way, a walk to where another place is within
  /// reach too. The later steps first, as a walk is needless once what it led to is.
  void leave_out_needless() {
    for (std::size_t before = 0; before != steps_.size();) {
      before = steps_.size();
      for (std::size_t i = steps_.size(); i-- > 0;) {
        auto without = steps_;
        without.erase(without.begin() + static_cast<std::ptrdiff_t>(i));
        if (reaches_goal(without)) steps_ = std::move(without);
      }
    }
  }

  std::vector<std::string> lines() const {
    std::vector<std::string> all;
    World world = start_;
    for (const Step& step : steps_) {
      all.push_back(step_text(setting_, problem_, world, step));
      if (problem_.watching) all.insert(all.end(), {"(note)", "(judge)"});
      (void)perform(setting_, world, step);
    }
    return all;
  }

  /// Pieces have other names in physics: the n-th cut from a whole is the n-th here.
  Id id_of(const std::string& name) const {
    if (const Id id = setting_.objects.named(name); id != kNobody) return id;
    for (const auto& [piece, whole] : pieces_) {
      if (piece != name) continue;
      std::size_t place = 0;
      for (const auto& [other, same] : pieces_) {
        if (other == piece) break;
        if (same == whole) ++place;
      }
      const Id cut = setting_.objects.named(whole);
      for (std::size_t i = 0; i < world_.things.size(); ++i) {
        if (setting_.objects.things[i].whole == cut && place-- == 0) return Id::thing(i);
      }
    }
    return kNobody;
  }

  const symbolic::Setting& setting_;
  const World& start_;
  const symbolic::Goal& goal_;
  const Problem& problem_;
  const std::vector<std::pair<std::string, std::string>>& pieces_;
  World world_;  // after the steps
  std::vector<Step> steps_;
};

}  // namespace

std::string step_text(const symbolic::Setting& setting, const Problem& problem, const World& world, const Step& step) {
  return StepWriter(setting, problem, world).write(step);
}

std::vector<Step> written_as(const symbolic::Setting& setting, const Problem& problem, const World& world,
                             const Step& step) {
  const auto steps = problem.watching ? atomic_steps(setting, world, step) : std::nullopt;
  if (!steps) return {step};
  std::vector<Step> all = steps->there;
  if (steps->runs_tap && world[step.target].has(Predicate::PowerOff))
    all.insert(all.end(), {{ActionType::TurnOn, step.target}, {ActionType::TurnOff, step.target}});
  all.insert(all.end(), steps->back.begin(), steps->back.end());
  return all;
}

Result<std::vector<std::string>> plan_for(const symbolic::Setting& setting, const World& start,
                                          const symbolic::Goal& goal, const Problem& problem,
                                          const std::vector<Action>& actions,
                                          const std::vector<std::pair<std::string, std::string>>& pieces) {
  return PlanWriter(setting, start, goal, problem, pieces).write(actions);
}

}  // namespace unietp::pddl
