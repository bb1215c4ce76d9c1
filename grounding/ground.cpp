#include "grounding/ground.h"

#include <algorithm>
#include <map>
#include <utility>

#include "generator/goal_parts.h"
#include "grounding/check_start.h"
#include "grounding/crowding.h"
#include "grounding/decoys.h"
#include "grounding/edits_in_words.h"
#include "grounding/enforce.h"
#include "grounding/goal_places.h"
#include "grounding/likelihood.h"
#include "grounding/numbers.h"
#include "grounding/polish.h"
#include "grounding/reachability.h"
#include "grounding/ready.h"
#include "grounding/scene_editor.h"
#include "logic/evaluate.h"
#include "scene/comparisons.h"

namespace unietp {
namespace {

constexpr int kRepairs = 4;

std::string said_of(const Specification& specification) {
  std::string text = specification.template_name + " on " + std::string(name_of(specification.simulator)) + " with";
  for (const auto& [placeholder, category] : specification.binding) text += " " + placeholder + "=" + category;
  return text;
}

Rejection rejected(const Specification& specification, const Scene& scene, const GroundingFailure& failure) {
  return {failure.reason, said_of(specification) + " in " + scene.id + ": " + failure.detail};
}

/// For each test of a phrase something that passes all the others and not this one; of one test, something else.
std::vector<Formula> told_apart_by(const Formula& where) {
  if (where.op != Formula::Op::And) return {negation(where)};
  std::vector<Formula> all;
  for (std::size_t i = 0; i < where.children.size(); ++i) {
    Formula other = where;
    other.children[i] = negation(where.children[i]);
    all.push_back(std::move(other));
  }
  return all;
}

/// Constraints that the goal's referring domains add to the start: something to pick out, something to tell it from by
/// each thing that is said of it.
std::vector<Formula> referring_constraints(const Specification& specification) {
  std::vector<Formula> constraints;
  const bool tells_apart =
      specification.split == Split::InstanceGrounding || specification.refinement != Referring::None;
  for (const QuantifiedDomain& one : quantified_domains(specification.goal)) {
    if (one.domain.where.empty() || !one.certain) continue;
    const Formula& where = one.domain.where.front();
    if (free_variables(where) != std::vector<std::string>{one.variable}) continue;
    Domain all = one.domain;
    all.where.clear();
    constraints.push_back(exists(one.variable, all, where));
    if (!tells_apart) continue;
    for (Formula& other : told_apart_by(where)) constraints.push_back(exists(one.variable, all, std::move(other)));
  }
  return constraints;
}

bool within_rounds(Enforcer& enforcer, SceneEditor& editor, const std::vector<Formula>& constraints,
                   const std::vector<Formula>& parts, int rounds) {
  for (int round = 0; round < rounds; ++round) {
    editor.reserved().clear();
    std::optional<GroundingFailure> first;
    for (const Formula& constraint : constraints) {
      if (!enforcer.make_true(constraint) && !first) first = editor.failure();
    }
    bool all = true;
    for (const Formula& constraint : constraints) {
      if (enforcer.holds(constraint)) continue;
      all = false;
      if (!first) first = {RejectionReason::StartNotMet, to_text(constraint) + " does not hold", {}};
    }
    // A part of the goal may hold by chance in this scene. Undo it; the next round repairs what that breaks.
    for (const Formula& part : parts) {
      if (first || !holds(part, enforcer.now())) continue;
      all = false;
      if (enforcer.make_false(part)) continue;
      first = {
          RejectionReason::PartHolds, to_text(part) + " holds and cannot be undone: " + editor.failure().detail, {}};
    }
    if (first) editor.fail(first->reason, first->detail);
    if (all) return true;
  }
  return false;
}

/// A door that was opened may stand where the agent stood.
void keep_standing(Workspace& workspace, const Home& home) {
  const auto other = workspace.other_grid();
  const NavigationGrid& grid = other ? *other : home.walk->grid;
  const Vec2 at = workspace.scene().agent.position;
  if (grid.free(grid.cell_at(at))) return;
  if (const auto cell = grid.nearest_free(at)) workspace.agent().position = grid.center(*cell);
  workspace.read_edges();
}

/// A start as it will be written and read.
struct Start {
  Delta changes;  // from the home
  Scene scene;
  GrownScene grown;
};

Start read_start(SceneEditor& editor, const Home& home) {
  keep_standing(editor.workspace(), home);
  editor.refresh();
  Start start;
  start.changes = editor.workspace().changes();
  start.scene = start_in(home.scene, home.places, start.changes);  // in the order that it will be read in
  start.grown = read_grown(home, start.scene);
  return start;
}

/// A category of which so many were added that the home has more than homes do: three gravy boats.
std::optional<std::string> added_too_often(const Workspace& workspace, const Delta& changes) {
  std::map<std::string, std::size_t> added;
  for (const Node& node : changes.nodes) {
    if (node.movable && !workspace.home()->places.find(node.id)) ++added[node.category];
  }
  for (const auto& [category, more] : added) {
    const std::size_t all = workspace.places().of(category).size();
    if (!may_be_so_many(workspace, all - more, more, category)) return category;
  }
  return std::nullopt;
}

/// Whether such things are usually on or in something of the home where the goal does not put them.
bool has_other_usual_place(const Workspace& workspace, const std::string& category, const GoalPlaces& places) {
  const auto goal = places.find(category);
  const auto& all = workspace.household()->places_of(category);
  return std::any_of(all.begin(), all.end(), [&](const Household::Place& place) {
    return place.usual && !workspace.places().of(place.receptacle).empty() &&
           (goal == places.end() || !goal->second.contains(place.receptacle));
  });
}

/// Why no home looks like the start: more than 8 things differ from the home, more than 2 pieces of furniture of a
/// category were changed alike, something of which homes have one or two was added until it has more, or something that
/// was changed is odd where it is (oddness_of), or was added to a place that is not usual while the goal leaves it one
/// that is; nullopt when some does.
std::optional<GroundingFailure> odd_start(const Workspace& workspace, const GoalPlaces& places, bool dangerous) {
  constexpr std::size_t kMostChanged = 8;
  constexpr int kMostAlike = 2;
  const Delta changes = workspace.changes();
  const auto failure = [](std::string why) { return GroundingFailure{RejectionReason::OddStart, std::move(why), {}}; };
  const std::size_t changed = changes.nodes.size() + changes.removed.size();
  if (changed > kMostChanged) return failure(std::to_string(changed) + " things would not be as in the home");
  if (const auto category = added_too_often(workspace, changes))
    return failure("no home has so many things of " + *category);
  std::map<std::string, int> alike;
  for (const Node& node : changes.nodes) {
    if (!node.movable && ++alike[node.category] > kMostAlike)
      return failure("several " + node.category + " would have to be in a state that few of them are in");
    if (!node.movable || dangerous) continue;
    std::string why;
    const Oddness odd = oddness_of(workspace, node, &why);
    if (odd == Oddness::Senseless) return failure(std::move(why));
    if (odd == Oddness::Unusual && !workspace.home()->places.find(node.id) &&
        has_other_usual_place(workspace, node.category, places))
      return failure(node.id + " would come to where such things are only at times");
  }
  return std::nullopt;
}

/// Things that the start adds for the goal, when it adds nothing else that they could hide among.
std::optional<GroundingFailure> added_alone(const Home& home, const Scene& start, const Formula& goal) {
  const std::vector<std::string> asked = categories_of(goal);
  std::string alone;
  for (const Node& node : start.nodes) {
    if (!node.movable || home.places.find(node.id)) continue;
    if (std::find(asked.begin(), asked.end(), node.category) == asked.end()) return std::nullopt;
    alone = node.category;
  }
  if (alone.empty()) return std::nullopt;
  return GroundingFailure{RejectionReason::OddStart, "nothing but " + alone + " would be new in the home", {}};
}

}  // namespace

std::variant<Grounded, Rejection> ground(const Specification& specification, const Home& home,
                                         const Knowledge& knowledge, const Profile& profile,
                                         const GroundingOptions& options, Rng rng) {
  std::vector<Formula> constraints = specification.init;
  const auto referring = referring_constraints(specification);
  constraints.insert(constraints.end(), referring.begin(), referring.end());
  if (const auto why = refused_by_numbers(constraints, home, knowledge))
    return rejected(specification, home.scene, *why);
  Workspace workspace(home, knowledge);
  workspace.set_household(options.household);
  SceneEditor editor(workspace, goal_places(specification.goal), profile, options.draws_per_object,
                     rng.fork("edits", 0));
  Compared compared;
  compared.add(specification.goal);
  for (const Formula& constraint : constraints) compared.add(constraint);
  Enforcer enforcer(editor, std::move(compared), rng.fork("choices", 0));
  const auto parts = goal_parts(specification.goal);
  const auto is_sound = [&] {
    return std::all_of(constraints.begin(), constraints.end(),
                       [&](const Formula& constraint) { return enforcer.holds(constraint); }) &&
           std::none_of(parts.begin(), parts.end(), [&](const Formula& part) { return holds(part, enforcer.now()); });
  };
  const auto problem_of = [&](const Start& start, bool natural) {
    return check_start(specification, home, start.scene, start.grown, editor.touched(), knowledge, profile,
                       {options.pictured, natural});
  };
  Start start;
  std::optional<GroundingFailure> problem;
  for (int attempt = 0; attempt < kRepairs; ++attempt) {
    if (!within_rounds(enforcer, editor, constraints, parts, options.rounds)) {
      return rejected(specification, home.scene, editor.failure());
    }
    polish(editor, goal_places(specification.goal), is_sound);
    make_ready(editor, specification, is_sound);
    start = read_start(editor, home);
    problem = problem_of(start, options.natural);
    if (!problem) break;
    // What stands out of reach or unsteadily gets another place, then all is checked again.
    const bool misplaced =
        problem->reason == RejectionReason::NotReachable || problem->reason == RejectionReason::NotCalm;
    editor.reserved().clear();
    if (!misplaced || !editor.relocate(problem->subject, [](const Node&) { return true; })) break;
  }
  if (!problem && options.likely) problem = odd_start(workspace, goal_places(specification.goal), options.dangerous);
  if (problem) return rejected(specification, home.scene, *problem);
  if (options.decoys && add_decoys(editor, specification, home, rng.fork("decoys", 0)) > 0) {
    Start with_decoys = read_start(editor, home);
    if (is_sound() && !problem_of(with_decoys, true)) start = std::move(with_decoys);
  }
  if (options.decoys && options.likely) {
    if (const auto alone = added_alone(home, start.scene, specification.goal))
      return rejected(specification, home.scene, *alone);
  }
  Episode episode;
  episode.changes = std::move(start.changes);
  episode.start = std::move(start.scene);
  episode.specification = specification;
  episode.layout = home.scene.id;
  episode.edits = edits_in_words(home, episode.start, episode.changes, knowledge);
  KnownStart known = known_start(home, episode.start, std::move(start.grown));
  return Grounded{std::move(episode), std::move(known)};
}

}  // namespace unietp
