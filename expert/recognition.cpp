#include "expert/recognition.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "scene/fresh_id.h"

namespace unietp {
namespace {

constexpr double kSamePlace_m = 0.02;  // of what nobody moved
constexpr double kNear_m = 1.5;        // of where the agent's action must have led
constexpr double kSameSize_m = 0.005;

}  // namespace

Recognition::Recognition(Window& window, Mode mode) : window_(window), names_(mode == Mode::M3) {
  known_.rooms = window.known_scene().rooms;
  known_.openings = window.known_scene().openings;
  look();
}

Outcome Recognition::act(const Action& action) {
  if (!names_) return window_.act(action);
  Action said = action;
  for (std::string& name : said.args) {
    if (const auto called = called_.find(name); called != called_.end()) name = called->second;
  }
  Outcome outcome = window_.act(said);
  const bool takes = outcome.success && action.type == ActionType::PickUp && !action.args.empty();
  taken_ = takes ? action.args.front() : "";
  return outcome;
}

void Recognition::expect(const Delta& changes) {
  if (!names_) return;
  for (const Node& node : changes.nodes) {
    if (const auto place = places_.find(node.id)) {
      const Vec3 before = known_.nodes[*place].pose.position;
      if ((node.pose.position - before).norm() > kSamePlace_m) moved_.insert(node.id);
      known_.nodes.edit(*place) = node;
    } else {
      moved_.insert(node.id);
      places_.add(known_.nodes.size(), node);
      known_.nodes.push_back(node);
    }
  }
  gone_.insert(changes.removed.begin(), changes.removed.end());
}

void Recognition::look() {
  view_ = window_.view();
  body_ = window_.body();
  if (!names_) return;
  given_.assign(view_.size(), "");
  used_.clear();
  called_.clear();
  name_in_hand();
  name_by_place(false, kSamePlace_m);
  name_by_place(true, kNear_m);
  name_the_rest();
}

bool Recognition::may_be(const Node& seen, const Node& known) const {
  return !used_.contains(known.id) && !gone_.contains(known.id) && seen.archetype == known.archetype &&
         seen.color == known.color && seen.material == known.material &&
         (seen.size - known.size).cwiseAbs().maxCoeff() <= kSameSize_m;
}

void Recognition::remember(std::size_t seen, std::string name) {
  Node& node = view_[seen];
  called_[name] = std::exchange(node.id, name);
  if (const auto place = places_.find(name)) {
    node.slice_of = known_.nodes[*place].slice_of;
    known_.nodes.edit(*place) = node;
  } else {
    places_.add(known_.nodes.size(), node);
    known_.nodes.push_back(node);
  }
  moved_.erase(name);
  used_.insert(name);
  given_[seen] = std::move(name);
}

/// Who takes a thing knows which one is in the hand.
void Recognition::name_in_hand() {
  if (body_.held.empty()) held_.clear();
  for (std::size_t i = 0; i < body_.held.size(); ++i) {
    if (i == held_.size()) held_.push_back(std::exchange(taken_, ""));
    const auto seen =
        std::find_if(view_.begin(), view_.end(), [&](const Node& node) { return node.id == body_.held[i]; });
    if (seen == view_.end()) continue;
    if (held_[i].empty()) held_[i] = fresh_id(known_, places_, seen->category);
    body_.held[i] = held_[i];
    remember(static_cast<std::size_t>(seen - view_.begin()), held_[i]);
  }
}

/// The nearest first. `moved`: only what the agent has moved since it was seen, wherever that was.
void Recognition::name_by_place(bool moved, double most_m) {
  std::vector<std::tuple<double, std::size_t, std::size_t>> pairs;  // meters, in view, among what is known
  for (std::size_t i = 0; i < view_.size(); ++i) {
    if (!given_[i].empty()) continue;
    for (const std::size_t place : places_.of(view_[i].category)) {
      const Node& known = known_.nodes[place];
      const double away = (view_[i].pose.position - known.pose.position).norm();
      if (away <= most_m && (!moved || moved_.contains(known.id)) && may_be(view_[i], known))
        pairs.emplace_back(away, i, place);
    }
  }
  std::sort(pairs.begin(), pairs.end());
  for (const auto& [away, i, place] : pairs) {
    const std::string name = known_.nodes[place].id;
    if (given_[i].empty() && !used_.contains(name)) remember(i, name);
  }
}

void Recognition::name_the_rest() {
  for (std::size_t i = 0; i < view_.size(); ++i) {
    if (given_[i].empty()) remember(i, fresh_id(known_, places_, view_[i].category));
  }
}

}  // namespace unietp
