#include "grounding/check_goal.h"

#include <algorithm>
#include <array>
#include <map>
#include <tuple>

#include "core/keep_least.h"
#include "grounding/goal_places.h"
#include "logic/evaluate.h"

namespace unietp {
namespace {

using Op = Formula::Op;

constexpr std::size_t kMostWitnesses = 8;  // looked at beyond those that are wanted, as many as the expert reads
constexpr std::size_t kMostTools = 8;      // for one thing; twice as many as the expert tries

/// Whether a treatment brings a state about: on what lies in or on the tool, or by wiping with it.
bool brings_about(const TreatmentInfo& treatment, Predicate state) {
  if (treatment.by_hand == ActionType::Wipe) return state == Predicate::Clean;
  return std::find(treatment.states.begin(), treatment.states.end(), state) != treatment.states.end();
}

class GoalFeasibility {
 public:
  GoalFeasibility(const Scene& start, const NodeIndex& places, const Trace& trace, const Knowledge& knowledge,
                  const Profile& profile, Reach& reach, bool pictured)
      : start_(start),
        places_(places),
        trace_(trace),
        knowledge_(knowledge),
        profile_(profile),
        reach_(reach),
        pictured_(pictured) {}

  bool read(const Formula& formula) {
    switch (formula.op) {
      case Op::Atom:
        return atom(formula);
      case Op::And:
        return std::all_of(formula.children.begin(), formula.children.end(), [&](const auto& f) { return read(f); }) &&
               find_room_together(formula);
      case Op::Before:
        return std::all_of(formula.children.begin(), formula.children.end(), [&](const auto& f) { return read(f); });
      case Op::Or:
        return std::any_of(formula.children.begin(), formula.children.end(), [&](const auto& f) { return read(f); });
      case Op::AtEnd:
      case Op::Sometime:
        return read(formula.children[0]);
      case Op::Until:
        return read(formula.children[1]);
      case Op::Exists:
        return at_least(formula, 1);
      case Op::Forall:
        return at_least(formula, members(formula).size()) && find_room_together(formula);
      case Op::Count:
        if (formula.comparison == Comparison::Equal || formula.comparison == Comparison::AtLeast)
          return at_least(formula, static_cast<std::size_t>(std::max(0, formula.number)));
        if (formula.comparison == Comparison::Greater)
          return at_least(formula, static_cast<std::size_t>(std::max(0, formula.number + 1)));
        return true;
      default:
        return true;  // what is only kept, taken away or compared needs nothing new
    }
  }

  /// The first truth that could not come about, in words.
  const std::string& missing() const { return missing_; }
  /// The first place that does not take all that is to be there at once, in words; "" when there is none.
  const std::string& crowded() const { return crowded_; }
  /// Id of the first thing that cannot be seen; "" when there is none.
  const std::string& unseen() const { return unseen_; }

 private:
  std::vector<EntityIndex> members(const Formula& formula) const {
    return members_of(formula.domain, formula.variable, trace_, names_);
  }

  bool at_least(const Formula& formula, std::size_t wanted) {
    if (makes_slices(formula.domain) && wanted > 0) return can_be_sliced(formula.domain);
    std::size_t found = 0;
    auto all = members(formula);
    if (all.size() < wanted && missing_.empty())
      missing_ = "there are " + std::to_string(all.size()) + " of " + to_text(formula.domain);
    keep_least(all, wanted + kMostWitnesses, [this](EntityIndex member) {
      return away(places_.find(trace_.entities[member].id), start_.agent.position);
    });
    // Behind doors the way of the body is looked for anew.
    if (wanted < all.size()) {
      std::stable_partition(all.begin(), all.end(), [this](EntityIndex member) {
        const auto place = places_.find(trace_.entities[member].id);
        return !place || reach_.lies_open(*place);
      });
    }
    for (const EntityIndex member : all) {
      if (found >= wanted) break;
      names_.emplace_back(formula.variable, member);
      if (read(formula.children[0])) ++found;
      names_.pop_back();
    }
    return found >= wanted;
  }

  double away(std::optional<std::size_t> node, const Vec2& from) const {
    return node ? (start_.nodes[*node].pose.position.head<2>() - from).norm() : 0;
  }

  /// There are slices, or something to be cut and something to cut it with.
  bool can_be_sliced(const Domain& domain) {
    if (!trace_.entities.of(domain).empty()) return true;
    const bool sliced = std::any_of(domain.members.begin(), domain.members.end(), [this](const Domain::Member& member) {
      const auto& wholes = places_.of(member.category);
      return std::any_of(wholes.begin(), wholes.end(), [this](std::size_t whole) { return is_found(whole); }) &&
             is_cut_by_something(member.category);
    });
    if (!sliced && missing_.empty()) missing_ = "there is nothing to be cut for " + to_text(domain);
    return sliced;
  }

  bool is_cut_by_something(const std::string& category) {
    const auto effects = knowledge_.effects_on(category, Treatment::Slices);
    const bool cut =
        effects.empty() || std::any_of(effects.begin(), effects.end(), [this](const Effect* effect) {
          const auto& tools = places_.of(effect->tool);
          return std::any_of(tools.begin(), tools.end(), [this](std::size_t tool) { return is_found(tool); });
        });
    if (!cut && missing_.empty()) missing_ = "there is nothing that cuts " + category;
    return cut;
  }

  /// The agent gets at it and, where it has to, sees it.
  bool is_found(std::size_t node) {
    if (!start_.nodes[node].movable) return true;
    if (reach_.object(node)) return shows(node);
    if (missing_.empty()) missing_ = start_.nodes[node].id + " is out of reach";
    return false;
  }

  std::optional<EntityIndex> entity_of(const Term& term) const {
    if (term.kind != Term::Kind::Variable) return std::nullopt;
    const auto bound =
        std::find_if(names_.rbegin(), names_.rend(), [&](const auto& one) { return one.first == term.name; });
    return bound == names_.rend() ? std::nullopt : std::optional(bound->second);
  }
  /// Place of the node that a term stands for; nullopt for rooms, the agent and symbols.
  std::optional<std::size_t> node_of(const Formula& atom, std::size_t term) const {
    if (atom.terms.size() <= term) return std::nullopt;
    const auto entity = entity_of(atom.terms[term]);
    if (!entity || trace_.entities[*entity].kind != Entity::Kind::Object) return std::nullopt;
    return places_.find(trace_.entities[*entity].id);
  }

  bool atom(const Formula& formula) {
    if (holds_in(formula, trace_, 0, names_)) return true;
    const auto subject = node_of(formula, 0), object = node_of(formula, 1);
    if (!subject) return true;
    const auto key = std::tuple(formula.predicate, *subject, object.value_or(start_.nodes.size()));
    const auto known = known_.find(key);
    if (known != known_.end()) return known->second;
    const bool seen = shows(*subject) && (!object || shows(*object));
    const bool possible = seen && comes_about(formula, *subject, object);
    if (seen && !possible && missing_.empty()) {
      missing_ = std::string(info(formula.predicate).name) + " of " + start_.nodes[*subject].id;
      if (object) missing_ += " and " + start_.nodes[*object].id;
      missing_ += out_of_reach_ ? " is out of reach" : " has no spot, or no way to it";
    }
    return known_.emplace(key, possible).first->second;
  }

  /// What is to be on or in each place at the same time.
  using Together = std::map<std::pair<std::size_t, bool>, std::vector<std::size_t>>;
  void collect(const Formula& formula, Together& together) {
    if (formula.op == Op::And || formula.op == Op::AtEnd) {
      for (const Formula& child : formula.children) collect(child, together);
    } else if (formula.op == Op::Forall && !makes_slices(formula.domain)) {
      for (const EntityIndex member : members(formula)) {
        names_.emplace_back(formula.variable, member);
        collect(formula.children[0], together);
        names_.pop_back();
      }
    } else if (formula.op == Op::Atom) {
      const bool inside = formula.predicate == Predicate::Inside;
      const auto subject = node_of(formula, 0), object = node_of(formula, 1);
      if ((!inside && formula.predicate != Predicate::On) || !subject || !object || *subject == *object) return;
      auto& things = together[{*object, inside}];
      if (std::find(things.begin(), things.end(), *subject) == things.end()) things.push_back(*subject);
    }
  }
  bool find_room_together(const Formula& formula) {
    Together together;
    collect(formula, together);
    return std::all_of(together.begin(), together.end(), [this](const auto& one) {
      const auto& [place, things] = one;
      if (things.size() < 2) return true;
      const auto known = known_together_.find(one);
      if (known != known_together_.end()) return known->second;
      const bool fits = reach_.room_for_all(things, place.first, place.second);
      if (!fits && crowded_.empty())
        crowded_ = start_.nodes[place.first].id + " has no room for " + std::to_string(things.size()) +
                   " things such as " + start_.nodes[things.front()].id + " at once";
      return known_together_.emplace(one, fits).first->second;
    });
  }

  bool shows(std::size_t node) {
    if (!pictured_ || !start_.nodes[node].movable || reach_.shows(node)) return true;
    if (unseen_.empty()) unseen_ = start_.nodes[node].id;
    return false;
  }

  bool comes_about(const Formula& formula, std::size_t subject, std::optional<std::size_t> object) {
    // What is moved or treated has to be within reach itself, not only one of its kind.
    out_of_reach_ = start_.nodes[subject].movable && !reach_.object(subject);
    if (out_of_reach_) return false;
    switch (formula.predicate) {
      case Predicate::Sliced:
        return is_cut_by_something(start_.nodes[subject].category);
      case Predicate::On:
      case Predicate::Inside:
        return !object || reach_.spot_for(subject, *object, formula.predicate == Predicate::Inside);
      case Predicate::Open:
      case Predicate::Closed:
        return reach_.swings(subject);
      case Predicate::InRoom:
        return spot_in_room(subject, trace_.entities[entity_of(formula.terms[1]).value()].id);
      default:
        return treatable(formula, subject);
    }
  }

  /// On the floor where the simulator lets things fall, else on or in a piece of furniture.
  bool spot_in_room(std::size_t subject, const std::string& room) {
    if (profile_.offers(ActionType::Drop)) return true;
    for (const Edge& edge : start_.edges) {
      if (edge.relation != Predicate::InRoom || edge.to != room) continue;
      const auto place = places_.find(edge.from);
      if (!place || start_.nodes[*place].movable) continue;
      if (reach_.spot_for(subject, *place, false) || reach_.spot_for(subject, *place, true)) return true;
    }
    return false;
  }

  /// Something in the home brings the state about: a place that takes the thing, or a tool that is found.
  bool treatable(const Formula& formula, std::size_t subject) {
    if (!start_.nodes[subject].movable) return true;
    const std::string symbol = formula.terms.size() > 1 ? formula.terms[1].name : "";
    bool any_rule = false;
    for (const TreatmentInfo& treatment : all_treatments()) {
      if (!brings_about(treatment, formula.predicate)) continue;
      for (const Effect* effect : knowledge_.effects_on(start_.nodes[subject].category, treatment.treatment)) {
        if (!symbol.empty() && symbol != "any" && effect->gives != symbol) continue;
        any_rule = true;
        const bool inside = has_need(*effect, EffectNeed::Inside) || has_need(*effect, EffectNeed::UnderTap);
        const bool on = !inside && !has_need(*effect, EffectNeed::Held) && treatment.treatment != Treatment::Wipes;
        auto tools = places_.of(effect->tool);
        keep_least(tools, kMostTools,
                   [&](std::size_t tool) { return away(tool, start_.nodes[subject].pose.position.head<2>()); });
        for (const std::size_t tool : tools) {
          if ((!inside && !on) ? is_found(tool) : reach_.spot_for(subject, tool, inside)) return true;
        }
      }
    }
    return !any_rule;  // by what this gate knows nothing of
  }

  const Scene& start_;
  const NodeIndex& places_;
  const Trace& trace_;
  const Knowledge& knowledge_;
  const Profile& profile_;
  Reach& reach_;
  Assignment names_;
  std::map<std::tuple<Predicate, std::size_t, std::size_t>, bool> known_;
  std::map<Together::value_type, bool> known_together_;
  bool pictured_, out_of_reach_ = false;
  std::string missing_, unseen_, crowded_;
};

}  // namespace

std::optional<GroundingFailure> check_goal(const Specification& specification, const Scene& start,
                                           const NodeIndex& places, const Trace& trace, const Knowledge& knowledge,
                                           const Profile& profile, Reach& reach, bool pictured) {
  GoalFeasibility possible(start, places, trace, knowledge, profile, reach, pictured);
  if (possible.read(specification.goal)) return std::nullopt;
  if (!possible.unseen().empty())
    return GroundingFailure{RejectionReason::NotSeen, possible.unseen() + " shows clearly from nowhere", {}};
  if (possible.missing().empty() && !possible.crowded().empty())
    return GroundingFailure{RejectionReason::NotTogether, possible.crowded(), {}};
  return GroundingFailure{RejectionReason::NoSpot, possible.missing(), {}};
}

}  // namespace unietp
