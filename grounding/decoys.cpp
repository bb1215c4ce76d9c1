#include "grounding/decoys.h"

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "grounding/crowding.h"
#include "grounding/likelihood.h"
#include "grounding/spoken_names.h"

namespace unietp {
namespace {

constexpr int kTriesPerDecoy = 4, kTriesPerMoved = 3, kTriesPerRestated = 6;
constexpr std::size_t kMostAdded = 20;  // to one start
constexpr int kLeastDecoys = 4;         // for each category that was added to, also at unusual places
constexpr std::size_t kMostMoved = 24;
constexpr std::size_t kMostRestated = 15;

/// A thing that a start added: its room or nullptr, what it is on or in, and whether others may be at unusual places.
struct Added {
  const Room* room = nullptr;
  std::string below = {};
  StateSet states = {};
  bool unusual = false;
  int together = 1;  // how many of its category were added at its place
};

/// A state that the start gave a thing of the home, and all that the thing is in since.
struct Given {
  State state;
  StateSet all;
};

class Decoys {
 public:
  Decoys(SceneEditor& editor, const Specification& specification, const Home& home, Rng rng)
      : editor_(editor), home_(home), rng_(rng) {
    for (const std::string& category : categories_of(specification.goal)) speak_of(category);
    for (const Formula& constraint : specification.init) {
      for (const std::string& category : categories_of(constraint)) speak_of(category);
    }
    for (const auto& [category, places] : goal_places(specification.goal)) places_.insert(places.begin(), places.end());
    for (const Effect& effect : knowledge().effects()) {
      if (effect.treatment == Treatment::Slices && effect.gives != effect.target)
        sliced_.emplace(effect.gives, effect.target);
    }
  }

  int run(const Formula& goal) {
    std::vector<std::string> asked = categories_of(goal);
    std::sort(asked.begin(), asked.end());
    asked.erase(std::unique(asked.begin(), asked.end()), asked.end());
    for (const std::string& category : asked) {
      const auto added = added_of(category);
      const auto number = static_cast<int>(number_in_home(category));
      if (!added.empty()) {
        add_for(*knowledge().find(category), number, added);
      } else if (number > 1 && is_movable(category)) {  // others come to be as many
        add_for(*knowledge().find(category), number - 1, {Added{}});
      }
      for (const Room* room : rooms_of_moved(category)) move_into(room, category);
      for (const Given& given : states_given(category)) give_to_others(given);
    }
    return static_cast<int>(added_ + moved_ + restated_);
  }

 private:
  Workspace& workspace() { return editor_.workspace(); }
  const Knowledge& knowledge() { return workspace().knowledge(); }

  void speak_of(const std::string& name) {
    const Category* category = knowledge().find(name);
    if (category == nullptr || !spoken_.insert(name).second) return;
    const auto names = names_of(*category, knowledge());
    names_.insert(names.begin(), names.end());
  }

  /// The movable things of a category that the home lacks.
  std::vector<Added> added_of(const std::string& category) {
    editor_.refresh();
    std::vector<Added> added;
    for (const std::size_t place : workspace().places().of(category)) {
      const Node& node = workspace().scene().nodes[place];
      if (node.movable && !home_.places.find(node.id))
        added.push_back({workspace().room_of(place), category_below(node), node.states});
    }
    for (Added& one : added) {
      one.together = static_cast<int>(std::count_if(added.begin(), added.end(), [&](const Added& other) {
        return other.room == one.room && other.below == one.below;
      }));
    }
    return added;
  }

  /// Of what a thing is on or in, as last read; "" for nothing.
  std::string category_below(const Node& node) {
    const auto& trace = workspace().current_state().now();
    const auto entity = workspace().current_state().reader().find(node.id);
    if (!entity) return {};
    for (const auto& [relation, other] : trace.states.front().relations(*entity)) {
      if (relation != Predicate::On && relation != Predicate::Inside) continue;
      if (const auto host = workspace().places().find(trace.entities[other].id))
        return workspace().scene().nodes[*host].category;
    }
    return {};
  }

  /// Of the movable things of a category that are elsewhere in the home: the room of each.
  std::vector<const Room*> rooms_of_moved(const std::string& category) {
    std::vector<const Room*> rooms;
    for (const std::size_t place : workspace().places().of(category)) {
      const Node& node = workspace().scene().nodes[place];
      const auto before = home_.places.find(node.id);
      if (node.movable && before && home_.scene.nodes[*before].pose.position != node.pose.position)
        rooms.push_back(workspace().room_of(place));
    }
    return rooms;
  }

  /// The states that movable things of a category are in and are not in the home, once for each thing.
  std::vector<Given> states_given(const std::string& category) {
    std::vector<Given> given;
    for (const std::size_t place : workspace().places().of(category)) {
      const Node& node = workspace().scene().nodes[place];
      const auto before = home_.places.find(node.id);
      if (!node.movable || !before) continue;
      for (const State& state : node.states.all()) {
        if (!home_.scene.nodes[*before].states.has(state) && may_be_common(state))
          given.push_back({state, node.states});
      }
    }
    return given;
  }

  std::size_t number_in_home(const std::string& category) const { return home_.places.of(category).size(); }

  /// The category whose places and rooms are a category's: a slice of which nobody spoke lies where the whole does.
  std::string_view kept_as(const Category& category) {
    const auto whole = sliced_.find(category.name);
    const auto* household = workspace().household();
    const bool known = household != nullptr && !household->places_of(category.name).empty();
    return whole == sliced_.end() || known ? std::string_view(category.name) : whole->second;
  }

  bool can_be_decoy(const Category& category) {
    return category.movable && !spoken_.contains(category.name) && is_usual_at(category, "");
  }

  bool is_spoken_of(const Category& category) {
    const auto names = names_of(category, knowledge());
    return std::any_of(names.begin(), names.end(), [&](std::string_view name) {
      return std::any_of(names_.begin(), names_.end(),
                         [&](std::string_view other) { return may_mean(name, other) || may_mean(other, name); });
    });
  }

  bool is_movable(const std::string& name) {
    const Category* category = knowledge().find(name);
    return category != nullptr && category->movable;
  }

  bool can_be_in(const std::string& category, const State& state) {
    const auto group = info(state.predicate == Predicate::Filled ? Predicate::Empty : state.predicate).group;
    return group.empty() || knowledge().has(category, group);
  }

  /// How many states of a thing the others of a category can never be in.
  std::ptrdiff_t missing_states(const Category& category, const Added& model) {
    const auto& states = model.states.all();
    return std::count_if(states.begin(), states.end(),
                         [&](const State& state) { return may_be_common(state) && !can_be_in(category.name, state); });
  }

  /// Those of which the home has that number come first, of these such as can be in the states, in a random order.
  std::vector<const Category*> like(const Category& asked, int number, const Added& model) {
    const bool has_models = !knowledge().assets_of(asked.name).empty();
    const bool is_sliced = sliced_.contains(asked.name);  // no home has those
    using Unlike = std::pair<int, std::ptrdiff_t>;
    std::vector<std::pair<Unlike, const Category*>> others;
    for (const Category& category : knowledge().categories()) {
      if (!can_be_decoy(category) || sliced_.contains(category.name) != is_sliced ||
          knowledge().assets_of(category.name).empty() == has_models)
        continue;
      const int gap = std::abs(static_cast<int>(number_in_home(category.name)) - number);
      others.emplace_back(Unlike{gap, missing_states(category, model)}, &category);
    }
    rng_.shuffle(others);
    std::stable_sort(others.begin(), others.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<const Category*> alike;
    for (const auto& [unlike, category] : others) alike.push_back(category);
    return alike;
  }

  /// At usual places first; where too few find one, more come to unusual places. Where none does, some come even to
  /// where there is a crowd: what stands alone would be found at once.
  void add_for(const Category& asked, int number, std::vector<Added> models) {
    constexpr int kAnyNumber = 1000;
    int added = add_for(asked, number, models, kDecoys);
    for (Added& model : models) model.unusual = true;
    if (added < kLeastDecoys) added += add_for(asked, number, models, kLeastDecoys - added);
    for (Added& model : models) model.together = kAnyNumber;
    if (added == 0) add_for(asked, number, models, 2);
  }

  /// How many were added, at most `wanted`.
  int add_for(const Category& asked, int number, const std::vector<Added>& models, int wanted) {
    int left = wanted, tries = kTriesPerDecoy * kDecoys;
    for (const Category* category : like(asked, number, models.front())) {
      if (left == 0 || tries == 0 || added_ + models.size() > kMostAdded) break;
      const bool suits =
          std::all_of(models.begin(), models.end(), [&](const Added& one) { return is_kept_in(*category, one.room); });
      const bool in_crowd = models.front().together > static_cast<int>(models.size());
      if (!suits || is_spoken_of(*category)) continue;
      if (!in_crowd && !may_be_so_many(workspace(), number_in_home(category->name), models.size(), category->name))
        continue;
      --tries;
      if (!add_like_each(*category, models)) continue;
      --left;
      spoken_.insert(category->name);  // each once
    }
    return wanted - left;
  }

  /// Whether homes have such things in the room.
  bool is_found_in(const std::string& category, const Room* room) {
    const auto* household = workspace().household();
    return household == nullptr || room == nullptr || household->is_found_in(category, room->type);
  }

  /// Moves things of the home that the task does not speak of into the room, each once: first those that homes have
  /// there or not as they have what was asked for there or not, of these such as are kept there about as often. Where
  /// homes do not have it there, and too few others find a place in the room, more go to other rooms where homes do not
  /// have them.
  void move_into(const Room* room, const std::string& asked) {
    const auto suits = [&](const std::string& category) {
      const auto* household = workspace().household();
      return household == nullptr || room == nullptr ? 1 : household->in_room(category, room->type);
    };
    const bool is_stray = !is_found_in(asked, room);
    std::vector<std::pair<std::pair<bool, double>, std::string>> ids;
    for (const Node& node : home_.scene.nodes) {
      const Category* category = knowledge().find(node.category);
      if (category == nullptr || !can_be_decoy(*category) || !(is_stray || is_kept_in(*category, room))) continue;
      const auto place = workspace().places().find(node.id);
      if (!place || workspace().scene().nodes[*place] != node) continue;
      const bool unlike = is_found_in(node.category, room) == is_stray || !is_kept_in(*category, room);
      ids.push_back({{unlike, std::abs(suits(node.category) - suits(asked))}, node.id});
    }
    rng_.shuffle(ids);
    std::stable_sort(ids.begin(), ids.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    int left = kMovedDecoys, tries = kTriesPerMoved * kMovedDecoys;
    for (const auto& [unlike, id] : ids) {
      const std::string& category = home_.scene.nodes[*home_.places.find(id)].category;
      if (is_enough(workspace(), category, moved_of_[category])) continue;
      if (left == 0 || tries-- == 0 || moved_ == kMostMoved) break;
      const bool strays_elsewhere = is_stray && unlike.first;
      if (!(strays_elsewhere ? move_astray(id) : move_into(id, room))) continue;
      ++moved_;
      ++moved_of_[category];
      --left;
    }
  }

  bool move_into(const std::string& id, const Room* room) {
    return move(id, false, [this, room](const Node& host) {
      return room == nullptr || workspace().room_of(*workspace().places().find(host.id)) == room;
    });
  }

  /// Into a room where homes do not have such things.
  bool move_astray(const std::string& id) {
    const std::string category = home_.scene.nodes[*home_.places.find(id)].category;
    return move(id, true, [this, category](const Node& host) {
      const Room* room = workspace().room_of(*workspace().places().find(host.id));
      return room != nullptr && !is_found_in(category, room) && is_kept_in(*knowledge().find(category), room);
    });
  }

  bool move(const std::string& id, bool unusual, const std::function<bool(const Node&)>& accept) {
    const std::size_t place = *workspace().places().find(id);
    if (!workspace().carried_by(place).empty()) return false;
    const Node before = workspace().scene().nodes[place];
    const Category& category = *knowledge().find(before.category);
    const auto is_free_there = is_free(category, {.unusual = unusual}, draw_goal_place(category));
    if (!editor_.relocate(id, [&](const Node& host) { return accept(host) && is_free_there(host); })) return false;
    if (is_sensible(id, unusual ? Oddness::Unusual : Oddness::None)) return true;
    editor_.replace(before);
    editor_.refresh();
    return false;
  }

  /// Gives a state to things of the home that the task does not speak of and that no other change has touched but such.
  void give_to_others(const Given& given) {
    const State& state = given.state;
    std::vector<std::pair<int, std::string>> ids;
    for (const Node& node : home_.scene.nodes) {
      const auto place = workspace().places().find(node.id);
      if (!place || !node.movable || spoken_.contains(node.category)) continue;
      const Node& now = workspace().scene().nodes[*place];
      if (now.states.has(state) || (now != node && !given_states_.contains(node.id))) continue;
      // A wine bottle is full of wine or empty.
      if (state.predicate == Predicate::Filled && !knowledge().effects_of(node.category, Treatment::Fills).empty())
        continue;
      ids.emplace_back(unlike(now, given), node.id);
    }
    rng_.shuffle(ids);
    std::stable_sort(ids.begin(), ids.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    int left = kRestatedDecoys, tries = kTriesPerRestated * kRestatedDecoys;
    for (const auto& [gap, id] : ids) {
      if (left == 0 || tries == 0 || restated_ == kMostRestated) break;
      const std::string& category = home_.scene.nodes[*home_.places.find(id)].category;
      if (is_enough(workspace(), category, restated_of_[category])) continue;
      const Node before = workspace().scene().nodes[*workspace().places().find(id)];
      if (!editor_.set_state(id, state.predicate, state.symbol, true)) continue;
      --tries;
      if (is_sensible(id)) {
        given_states_.insert(id);
        give_states(id, given.all, nullptr);
        ++restated_;
        ++restated_of_[category];
        --left;
      } else {
        editor_.replace(before);
        editor_.refresh();
      }
    }
  }

  /// How far a thing is from the other states of the one that was given a state: a dirty mug full of water is told from
  /// the clean ones that are full by being both. What can never be in a state counts twice.
  int unlike(const Node& node, const Given& given) {
    int sum = 0;
    for (const State& other : given.all.all()) {
      if (other == given.state || !may_be_common(other) || node.states.has(other)) continue;
      sum += can_be_in(node.category, other) ? 1 : 2;
    }
    return sum;
  }

  bool is_kept_in(const Category& category, const Room* room) {
    const auto* household = workspace().household();
    return room == nullptr || household == nullptr ||
           household->in_room(kept_as(category), room->type) >= Household::kNoRoom;
  }

  /// Where a task could want such a thing to be: in one of its usual places, which its start then keeps it from.
  std::string draw_goal_place(const Category& category) {
    const auto* household = workspace().household();
    if (household == nullptr) return {};
    std::vector<double> weights;
    const auto& places = household->places_of(kept_as(category));
    for (const auto& place : places) weights.push_back(place.weight);
    return places[rng_.weighted(weights)].receptacle;
  }

  bool add_like_each(const Category& category, const std::vector<Added>& models) {
    const std::string wanted = draw_goal_place(category);
    std::vector<std::string> ids;
    for (const Added& model : models) {
      if (const auto id = add_like(category, model, wanted)) ids.push_back(*id);
    }
    if (ids.size() == models.size()) {
      added_ += ids.size();
      return true;
    }
    for (const std::string& id : ids) editor_.remove(id);
    return false;
  }

  /// On or in the same kind of furniture where there is a place for it, and in the same states as far as it can be.
  std::optional<std::string> add_like(const Category& category, const Added& model, const std::string& wanted) {
    const auto is_free_there = is_free(category, model, wanted);
    std::optional<std::string> id;
    if (is_kept_at(category, model.below))
      id = editor_.add_object(category.name, [&](const Node& host) {
        return host.category == model.below && may_hold(host, category, model, wanted);
      });
    if (!id) id = editor_.add_object(category.name, is_free_there);
    if (!id) return id;
    if (!is_sensible(*id, model.unusual ? Oddness::Unusual : Oddness::None)) {
      editor_.remove(*id);
      return std::nullopt;
    }
    // A dirty plate stands where clean ones do not.
    give_states(*id, model.states, is_free(category, {.room = model.room, .unusual = true}, wanted));
    return id;
  }

  /// What few at its place are in, it is put elsewhere for, on or in what is accepted; without `accept` it stays, and
  /// is not given what few there are in.
  void give_states(const std::string& id, const StateSet& states, const std::function<bool(const Node&)>& accept) {
    for (const State& state : states.all()) {
      const Node before = workspace().scene().nodes[*workspace().places().find(id)];
      if (before.states.has(state) || !may_be_common(state)) continue;
      if (!editor_.set_state(id, state.predicate, state.symbol, true) || is_sensible(id)) continue;
      if (accept == nullptr) {
        editor_.replace(before);
        editor_.refresh();
        continue;
      }
      const Node now = workspace().scene().nodes[*workspace().places().find(id)];
      const auto suits = [&](const Node& host) { return accept(host) && !is_rare_at(workspace(), now, host); };
      if (editor_.relocate(id, suits) && is_sensible(id)) continue;
      editor_.replace(before);
      editor_.refresh();
    }
  }

  bool is_kept_at(const Category& category, const std::string& receptacle) {
    const auto* household = workspace().household();
    return household != nullptr && !receptacle.empty() &&
           (household->place(kept_as(category), Predicate::On, receptacle) != nullptr ||
            household->place(kept_as(category), Predicate::Inside, receptacle) != nullptr);
  }

  /// Whether a receptacle is in the room, usual if it has to be, and not where this task or one for the thing puts
  /// things. Slices lie on or in something that is carried, or where they usually are: nobody leaves a slice of tomato
  /// in the toaster or on the desk.
  bool may_hold(const Node& host, const Category& category, const Added& model, const std::string& wanted) {
    const bool holds_slices = host.movable && (workspace().household() == nullptr ||
                                               !workspace().household()->is_a(host.category, "cookware"));
    const bool suits = !sliced_.contains(category.name) || holds_slices || is_usual_at(category, host.category);
    return suits && host.category != wanted && !places_.contains(host.category) &&
           !(host.movable && spoken_.contains(host.category)) &&
           has_room_for(workspace(), category.name, host, model.together) &&
           (model.room == nullptr || workspace().room_of(*workspace().places().find(host.id)) == model.room) &&
           (model.unusual || is_usual_at(category, host.category));
  }
  /// The same; no food is heated there.
  std::function<bool(const Node&)> is_free(const Category& category, const Added& model, std::string wanted) {
    return [this, &category, model, wanted = std::move(wanted)](const Node& host) {
      const auto* household = workspace().household();
      const bool heats = household != nullptr && household->passes(host.category) && !household->washes(host.category);
      return may_hold(host, category, model, wanted) && !heats;
    };
  }

  /// Whether such things are usually on or in such a receptacle, or in any for ""; true without a household.
  bool is_usual_at(const Category& category, std::string_view receptacle) {
    if (workspace().household() == nullptr) return true;
    const auto& all = workspace().household()->places_of(kept_as(category));
    return std::any_of(all.begin(), all.end(), [&](const Household::Place& place) {
      return place.usual && (receptacle.empty() || place.receptacle == receptacle);
    });
  }

  /// Whether a thing is no odder where and as it is.
  bool is_sensible(const std::string& id, Oddness most = Oddness::Unusual) {
    editor_.refresh();
    const Node& node = workspace().scene().nodes[*workspace().places().find(id)];
    return oddness_of(workspace(), node) <= most;
  }

  SceneEditor& editor_;
  const Home& home_;
  Rng rng_;
  std::set<std::string, std::less<>> spoken_;            // categories
  std::set<std::string_view> names_;                     // of these
  std::set<std::string> places_;                         // categories of places that the goal names
  std::map<std::string_view, std::string_view> sliced_;  // categories that only slicing makes: of what
  std::set<std::string> given_states_;                   // ids of things that were given a state for that
  std::map<std::string, int> moved_of_, restated_of_;    // of a category
  std::size_t added_ = 0, moved_ = 0, restated_ = 0;
};

}  // namespace

int add_decoys(SceneEditor& editor, const Specification& specification, const Home& home, Rng rng) {
  return Decoys(editor, specification, home, rng).run(specification.goal);
}

}  // namespace unietp
