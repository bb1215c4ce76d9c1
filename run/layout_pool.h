#pragma once

#include <array>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "core/result.h"
#include "dataset/configuration.h"
#include "generator/scene_offer.h"
#include "grounding/home.h"
#include "resources/resources.h"
#include "run/blocks.h"

namespace unietp {

/// A home and what tasks in it can be about.
struct Layout {
  Home home;
  SceneOffer offer;  // categories: those that it has, or that can be put somewhere in it; and its room types
};

/// Homes of a run: those of Resources::homes, or else each is made when it is first asked for and then shared. A home
/// depends only on the configuration's source and seed, the simulator and its number. What it is made from must outlive
/// it. Safe to use from several threads.
class LayoutPool {
 public:
  /// The homes of a block.
  LayoutPool(const RunConfiguration& configuration, const Resources& resources, const BlockHomes& homes);
  /// The first so many homes of each simulator, or all that are given.
  LayoutPool(const RunConfiguration& configuration, const Resources& resources, int homes);

  /// How many homes a simulator has here.
  int size(Simulator simulator) const { return static_cast<int>(of(simulator).size()); }
  /// `index` in [0, size(simulator)). Errors: those of generate_layout, after a few tries. The reference is
  /// valid as long as the pool.
  const Result<Layout>& layout(Simulator simulator, int index);

 private:
  struct Entry {
    std::once_flag once;
    int number = 0;                // in the run
    const Scene* given = nullptr;  // of Resources::homes
    std::unique_ptr<Result<Layout>> layout;
  };
  const RunConfiguration& configuration_;
  const Resources& resources_;
  const std::vector<std::unique_ptr<Entry>>& of(Simulator simulator) const {
    return entries_[static_cast<std::size_t>(simulator)];
  }
  std::array<std::vector<std::unique_ptr<Entry>>, kSimulators.size()> entries_;
};

/// Categories that a scene has, and movable ones whose usual receptacles it has; and the types of its rooms. Sorted.
std::vector<std::string> offered_categories(const Scene& scene, const Knowledge& knowledge);

}  // namespace unietp
