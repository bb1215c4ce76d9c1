#include "simulation/portrait_quiz.h"

#include <array>
#include <functional>
#include <optional>
#include <utility>

#include "core/rng.h"

namespace unietp {
namespace {

using Categories = std::vector<const Category*>;

PortraitOptions view_of(const Category& category, Rng& rng) {
  constexpr double kAside_rad = 0.7, kAcrossTable_rad = 0.45, kArmsLength_rad = 0.85, kStanding_rad = 0.35;
  PortraitOptions view;
  view.turn_rad = rng.uniform(-kAside_rad, kAside_rad);
  view.down_rad = category.movable ? rng.uniform(kAcrossTable_rad, kArmsLength_rad) : kStanding_rad;
  view.on_table = category.movable;
  return view;
}

Node drawn(const Knowledge& knowledge, const Category& category, Rng& rng) {
  constexpr std::uint64_t kSeeds = 1000;
  return object_of(knowledge, category, static_cast<std::uint32_t>(rng.below(kSeeds)));
}

/// The categories of each simulator that `fits` takes, in a random order.
std::vector<Categories> shuffled(const std::vector<const Knowledge*>& knowledge, Rng& rng,
                                 const std::function<bool(const Knowledge&, const Category&)>& fits) {
  std::vector<Categories> all;
  for (const Knowledge* one : knowledge) {
    Categories taken;
    for (const Category& category : one->categories()) {
      if (fits(*one, category)) taken.push_back(&category);
    }
    rng.shuffle(taken);
    all.push_back(std::move(taken));
  }
  return all;
}

struct Drawn {
  const Knowledge* knowledge = nullptr;
  const Category* category = nullptr;
};

/// Takes from the simulators in turn, from the one at `turn` on, until there are enough or none is left.
std::vector<Drawn> in_turn(const std::vector<const Knowledge*>& knowledge, std::vector<Categories> all,
                           std::size_t count, std::size_t turn) {
  std::vector<Drawn> taken;
  for (std::size_t missed = 0; taken.size() < count && missed < all.size(); ++turn) {
    Categories& left = all[turn % all.size()];
    missed = left.empty() ? missed + 1 : 0;
    if (left.empty()) continue;
    taken.push_back({knowledge[turn % all.size()], left.back()});
    left.pop_back();
  }
  return taken;
}

void add_things(const std::vector<const Knowledge*>& knowledge, bool movable, std::size_t count, Rng rng,
                std::vector<QuizItem>& items) {
  const auto fits = [movable](const Knowledge&, const Category& category) { return category.movable == movable; };
  std::vector<QuizItem> things;
  for (const Drawn& one : in_turn(knowledge, shuffled(knowledge, rng, fits), count, 0)) {
    things.push_back({one.knowledge,
                      one.category,
                      {drawn(*one.knowledge, *one.category, rng)},
                      view_of(*one.category, rng),
                      movable ? "movable" : "furniture",
                      one.category->display});
  }
  rng.shuffle(things);
  items.insert(items.end(), things.begin(), things.end());
}

/// A state that can be asked for, the one of the same things without it, and the affordance of these things.
struct Contrast {
  State with;
  std::optional<State> without;
  std::string affordance;
};

std::vector<Contrast> contrasts() {
  std::vector<Contrast> all;
  for (const StateGroup& group : state_groups()) {
    for (std::size_t i = 1; i < group.predicates.size(); ++i) {
      const std::string symbol = group.predicates[i] == Predicate::Filled ? "any" : "";
      all.push_back({{group.predicates[i], symbol}, State{group.predicates.front(), ""}, group.affordance});
    }
  }
  all.push_back({{Predicate::Covered, "any"}, std::nullopt, "coverable"});
  return all;
}

Node with_state(const Node& node, const std::optional<State>& state) {
  Node changed = node;
  if (state) changed.states.set(*state);
  changed.opening = changed.states.has(Predicate::Open) ? 1 : 0;
  return changed;
}

std::string words_of(const State& state) {
  std::string words(info(state.predicate).name);
  if (!state.symbol.empty()) words += " " + state.symbol;
  return words;
}

/// Two pictures in a random order. `words`: of the first and the second of `shown`.
QuizItem pair_of(const Drawn& one, std::vector<Node> shown, std::pair<std::string, std::string> words, Rng& rng) {
  const std::string question = words.first + " or " + words.second;
  if (rng.chance(0.5)) {
    std::swap(shown[0], shown[1]);
    std::swap(words.first, words.second);
  }
  return {one.knowledge, one.category, std::move(shown), view_of(*one.category, rng), question, words.first};
}

std::string substance_for(Predicate state, Rng& rng) {
  constexpr std::array kLiquids{"water", "coffee", "wine", "milk"}, kCovers{"dust", "flour", "jam", "mud"};
  return state == Predicate::Filled ? rng.pick(kLiquids) : rng.pick(kCovers);
}

/// At most `count` pairs of one contrast, from the simulator at `turn` on.
std::vector<QuizItem> pairs_of(const Contrast& contrast, std::size_t turn,
                               const std::vector<const Knowledge*>& knowledge, std::size_t count, Rng rng) {
  const auto fits = [&](const Knowledge& one, const Category& category) {
    return one.has(category.name, contrast.affordance);
  };
  std::vector<QuizItem> pairs;
  for (const Drawn& one : in_turn(knowledge, shuffled(knowledge, rng, fits), count, turn)) {
    State with = contrast.with;
    if (!with.symbol.empty()) with.symbol = substance_for(with.predicate, rng);
    const Node node = drawn(*one.knowledge, *one.category, rng);
    const std::string without = contrast.without ? words_of(*contrast.without) : "not covered";
    pairs.push_back(
        pair_of(one, {with_state(node, with), with_state(node, contrast.without)}, {words_of(with), without}, rng));
  }
  return pairs;
}

}  // namespace

std::vector<QuizItem> quiz_of_things(const std::vector<const Knowledge*>& knowledge, std::size_t movables,
                                     std::size_t furniture, std::uint64_t seed) {
  const Rng rng(seed);
  std::vector<QuizItem> items;
  add_things(knowledge, true, movables, rng.fork("movables", 0), items);
  add_things(knowledge, false, furniture, rng.fork("furniture", 0), items);
  return items;
}

std::vector<QuizItem> quiz_of_states(const std::vector<const Knowledge*>& knowledge, std::size_t count,
                                     std::uint64_t seed) {
  const std::vector<Contrast> all = contrasts();
  Rng order = Rng(seed).fork("order", 0);
  std::vector<std::vector<QuizItem>> pairs;
  for (std::size_t i = 0; i < all.size(); ++i)
    pairs.push_back(pairs_of(all[i], i, knowledge, count, Rng(seed).fork("state", i)));
  std::vector<QuizItem> items;
  for (std::size_t round = 0; round < count; ++round) {
    for (const std::vector<QuizItem>& some : pairs) {
      if (round < some.size() && items.size() < count) items.push_back(some[round]);
    }
  }
  order.shuffle(items);
  return items;
}

std::vector<QuizItem> quiz_of_materials(const std::vector<const Knowledge*>& knowledge, std::size_t count,
                                        std::uint64_t seed) {
  Rng rng = Rng(seed).fork("materials", 0);
  const auto fits = [](const Knowledge&, const Category& category) { return category.materials.size() > 1; };
  std::vector<QuizItem> items;
  for (const Drawn& one : in_turn(knowledge, shuffled(knowledge, rng, fits), count, 0)) {
    std::vector<std::string> materials = one.category->materials;
    rng.shuffle(materials);
    Node first = drawn(*one.knowledge, *one.category, rng), second = first;
    first.material = materials[0];
    second.material = materials[1];
    items.push_back(pair_of(one, {first, second}, {materials[0], materials[1]}, rng));
  }
  rng.shuffle(items);
  return items;
}

}  // namespace unietp
