#include "simulation/moment_tree.h"

#include <algorithm>
#include <iterator>

#include "simulation/camera.h"

namespace unietp {
namespace {

std::string key_of(const Action& action) {
  std::string key(1, static_cast<char>(action.type));
  for (const std::string& argument : action.args) {
    key += argument;
    key += '\0';
  }
  return key;
}

}  // namespace

MomentTree::MomentTree(WorldState start, Viewer viewer) : state_(std::move(start)), viewer_(std::move(viewer)) {
  moments_.emplace_back();  // digests of moments are relative to the start
  moments_.front().stopped = state_.stopped();
  known_.emplace(Digest{}, MomentId());
}

void MomentTree::go(MomentId to) {
  std::vector<MomentId> down;
  MomentId up = here_, from = to;
  while (up != from) {
    if (moments_[up.index()].depth >= moments_[from.index()].depth) {
      state_.undo(moments_[up.index()].log);
      up = moments_[up.index()].parent;
    } else {
      down.push_back(from);
      from = moments_[from.index()].parent;
    }
  }
  for (auto next = down.rbegin(); next != down.rend(); ++next) state_.redo(moments_[next->index()].log);
  here_ = to;
}

const WorldState& MomentTree::at(MomentId moment) {
  if (moment != here_) go(moment);
  return state_;
}

const MomentTree::Step& MomentTree::step(MomentId at, const Action& action) {
  const auto [place, fresh] = moments_[at.index()].steps.try_emplace(key_of(action));
  Step& step = place->second;
  if (!fresh) return step;
  if (at != here_) go(at);
  step.next = at;
  std::vector<Part> parts;
  const auto end_part = [&] {
    const std::size_t begin = parts.empty() ? 0 : parts.back().end;
    WorldState::Change change = state_.change(begin);
    if (!change.delta.empty()) parts.push_back({state_.mark(), std::move(change)});
  };
  step.result = perform(state_, action, end_part);
  if (!step.result.success) {
    state_.back_to(0);
    return step;
  }
  WorldState::Change change = state_.change();
  if (!parts.empty()) parts.push_back({state_.mark(), state_.change(parts.back().end)});
  const bool stopped = state_.stopped();
  std::vector<Edit> log = state_.take_log();
  if (!parts.empty()) {
    state_.undo(log);
    step.passed = enter_all(at, std::move(parts), std::move(log));
    step.next = step.passed.back().moment;
  } else {
    const auto [next, is_new] = enter(at, change.digest_difference, log, stopped);
    step.next = next;
    if (is_new) {
      here_ = next;
    } else {
      state_.undo(log);  // a moment keeps the path by which it was reached first
    }
  }
  step.changes = std::move(change.delta);
  return step;
}

std::pair<MomentId, bool> MomentTree::enter(MomentId from, const Digest& difference, std::vector<Edit>& log,
                                            bool stopped) {
  Digest digest = moments_[from.index()].digest;
  digest += difference;
  const auto [known, is_new] = known_.try_emplace(digest, MomentId(moments_.size()));
  if (is_new) {
    const std::uint32_t depth = moments_[from.index()].depth + 1;
    Moment& moment = moments_.emplace_back();
    moment.parent = from;
    moment.depth = depth;
    moment.log = std::move(log);
    moment.digest = digest;
    moment.stopped = stopped;
  }
  return {known->second, is_new};
}

std::vector<PassedMoment> MomentTree::enter_all(MomentId from, std::vector<Part> parts, std::vector<Edit> log) {
  std::vector<PassedMoment> passed;
  std::size_t begin = 0;
  for (Part& part : parts) {
    const auto at = [&log](std::size_t i) {
      return std::make_move_iterator(log.begin() + static_cast<std::ptrdiff_t>(i));
    };
    std::vector<Edit> own(at(begin), at(part.end));
    begin = part.end;
    from = enter(from, part.change.digest_difference, own, false).first;  // no part of a step is `stop`
    passed.push_back({from, std::move(part.change.delta)});
  }
  return passed;
}

void MomentTree::forget_all_but(MomentId moment) {
  go(moment);
  auto visible = std::move(moments_[moment.index()].visible);
  auto shown = std::move(moments_[moment.index()].shown);
  auto boxes = std::move(moments_[moment.index()].boxes);
  moments_.clear();
  known_.clear();
  here_ = MomentId();
  Moment& first = moments_.emplace_back();
  first.stopped = state_.stopped();
  first.visible = std::move(visible);
  first.shown = std::move(shown);
  first.boxes = std::move(boxes);
  known_.emplace(Digest{}, here_);
}

const std::vector<VisibleObject>& MomentTree::visible(MomentId moment, double sight_m) {
  const auto [known, fresh] = moments_[moment.index()].visible.try_emplace(sight_m);
  if (fresh) {
    const WorldState& state = at(moment);
    known->second = viewer_.view(state.viewed(), state.agent(), *state.profile, sight_m);
  }
  return known->second;
}

bool MomentTree::shows(MomentId moment, std::string_view id) {
  const auto [known, fresh] = moments_[moment.index()].shown.try_emplace(std::string(id), false);
  if (!fresh) return known->second;
  const WorldState& state = at(moment);
  const auto node = state.index_of(id);
  if (!node) return false;
  const double away = (state.node(*node).pose.position - camera_of(state.agent(), *state.profile).at).norm();
  if (away > state.profile->sight_m) return false;
  known->second = viewer_.box_of(state.viewed(), *node, state.agent(), *state.profile).has_value();
  return known->second;
}

const std::optional<PixelBox>& MomentTree::unique_box(MomentId moment, std::string_view id) {
  const auto [known, fresh] = moments_[moment.index()].boxes.try_emplace(std::string(id));
  if (!fresh) return known->second;
  const auto& views = moments_[moment.index()].visible;
  if (const auto whole = views.find(kEndless_m); whole != views.end()) {  // sorted by id
    const auto& objects = whole->second;
    const auto one = std::find_if(objects.begin(), objects.end(), [&](const auto& object) { return object.id == id; });
    const auto first = std::find_if(objects.begin(), one,
                                    [&](const auto& other) { return one != objects.end() && other.box == one->box; });
    if (one != objects.end() && first == one) known->second = one->box;
    return known->second;
  }
  const WorldState& state = at(moment);
  const auto node = state.index_of(id);
  if (node) known->second = viewer_.first_with_box(state.viewed(), *node, state.agent(), *state.profile);
  return known->second;
}

const std::string* MomentTree::object_of_box(MomentId moment, const PixelBox& box) const {
  for (const auto& [id, meaning] : moments_[moment.index()].boxes) {
    if (meaning == box) return &id;
  }
  return nullptr;
}

}  // namespace unietp
