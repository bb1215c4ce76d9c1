#include "run/blocks.h"

#include <algorithm>
#include <cstdint>

namespace unietp {
namespace {

std::size_t position(Simulator simulator) { return static_cast<std::size_t>(simulator); }

/// The number of new homes for `tasks` of the `all` tasks that the run has of a simulator.
int homes_for(std::int64_t tasks, std::int64_t all) {
  constexpr std::int64_t kTasksAHome = 5, kFirst = 50, kTasksAHomeThen = 25;
  const auto up = [](std::int64_t a, std::int64_t b) { return (a + b - 1) / b; };
  const std::int64_t homes =
      up(std::min(all, kFirst), kTasksAHome) + std::max<std::int64_t>(0, all - kFirst) / kTasksAHomeThen;
  return all == 0 ? 0 : static_cast<int>(up(tasks * homes, all));
}

std::int64_t tasks_of(std::size_t simulator, const std::vector<TaskSlot>& slots) {
  return std::count_if(slots.begin(), slots.end(),
                       [&](const TaskSlot& slot) { return position(slot.simulator) == simulator; });
}

/// The number of homes of each simulator; empty when any number can be made.
std::vector<int> existing_homes(const RunConfiguration& configuration, const Resources& resources) {
  std::vector<int> counts(kSimulators.size(), 0);
  for (const Scene& home : resources.homes) ++counts[position(home.simulator)];
  if (!resources.homes.empty()) return counts;
  if (configuration.homes != HomeSource::Benchmark) return {};
  for (const BenchmarkLayout& home : resources.benchmark) ++counts[position(home.simulator)];
  return counts;
}

}  // namespace

std::vector<Block> blocks_of(const RunConfiguration& configuration, const Resources& resources,
                             const std::vector<TaskSlot>& slots) {
  const auto existing = existing_homes(configuration, resources);
  const auto size = static_cast<std::size_t>(configuration.block);
  std::size_t count = (slots.size() + size - 1) / size;
  for (const Simulator simulator : configuration.simulators) {
    if (!existing.empty()) count = std::min(count, std::max<std::size_t>(1, existing[position(simulator)]));
  }
  std::vector<Block> blocks;
  BlockHomes used{};
  for (std::size_t b = 0; b < count; ++b) {
    Block block;
    block.slots.assign(slots.begin() + static_cast<std::ptrdiff_t>(slots.size() * b / count),
                       slots.begin() + static_cast<std::ptrdiff_t>(slots.size() * (b + 1) / count));
    for (std::size_t s = 0; s < kSimulators.size(); ++s) {
      HomeRange& homes = block.homes[s];
      if (!existing.empty()) {
        const auto all = static_cast<std::size_t>(existing[s]);
        homes.first = static_cast<int>(all * b / count);
        homes.count = static_cast<int>(all * (b + 1) / count) - homes.first;
      } else {
        homes.first = used[s].count;
        homes.count = homes_for(tasks_of(s, block.slots), tasks_of(s, slots));
      }
      used[s].count += homes.count;
    }
    blocks.push_back(std::move(block));
  }
  return blocks;
}

}  // namespace unietp
