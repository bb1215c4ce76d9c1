#include "expert/known_world.h"

#include <algorithm>
#include <array>
#include <utility>

namespace unietp {
namespace {

// What is in reach from all around is so also where what nobody has seen yet stands beside it.
const std::array<Vec2, 4> kAside_m{Vec2{0.05, 0}, Vec2{-0.05, 0}, Vec2{0, 0.05}, Vec2{0, -0.05}};

}  // namespace

KnownHome& KnownWorld::home() {
  if (!home_) home_ = std::make_unique<KnownHome>(window_.known_scene(), profile_);
  return *home_;
}

World* KnownWorld::world() {
  if (!world_) {
    Scene scene = believed_ != nullptr ? *believed_ : window_.known_scene();
    KnownStart known = believed_ != nullptr ? home().of(scene) : home().start();
    auto made = World::create(std::move(scene), knowledge_, profile_, std::move(known));
    if (!made) return nullptr;
    world_ = std::make_unique<World>(std::move(*made));
  }
  return world_.get();
}

void KnownWorld::believe(const Scene& believed) {
  believed_ = &believed;
  world_ = nullptr;
}

void KnownWorld::follow(const Action& action) {
  if (world_) (void)world_->step(action);
}

bool KnownWorld::allows(const Action& action) {
  const World* known = world();
  if (known == nullptr) return true;
  World trial = *known;
  return trial.step(action).success;
}

KnownWorld::Obstacle KnownWorld::obstacle_to(const SearchOrder::Look& look, const std::vector<Action>& way) {
  const World* known = world();
  if (known == nullptr || look.from_here) return Obstacle::None;
  World trial = *known;
  if (!trial.step({ActionType::GoTo, {look.id}}).success) return Obstacle::NoWay;
  if (look.opens) {
    const Action open{ActionType::Open, {look.id}};
    const bool opened =
        trial.step(open).success || (trial.step({ActionType::TurnOff, {look.id}}).success && trial.step(open).success);
    return opened ? Obstacle::None : Obstacle::Shut;
  }
  trial = *known;
  const bool shows = std::all_of(way.begin(), way.end(), [&](const Action& one) { return trial.step(one).success; });
  return shows ? Obstacle::None : Obstacle::NoView;
}

bool KnownWorld::opens_from_here(const std::string& id) {
  const World* known = world();
  if (known == nullptr || (known->agent().position - window_.body().position).norm() > kStray_m) return false;
  const auto reached_from = [&](const Vec2& aside) {
    return known->in_reach_from(window_.body().position + aside, id);
  };
  if (!known->in_reach(id) || !std::all_of(kAside_m.begin(), kAside_m.end(), reached_from)) return false;
  if (!known->pictured_from(window_.body(), id)) return false;
  return allows({ActionType::Open, {id}});
}

}  // namespace unietp
