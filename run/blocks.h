#pragma once

#include <array>
#include <vector>

#include "dataset/configuration.h"
#include "resources/resources.h"
#include "run/slots.h"

namespace unietp {

/// Homes of one simulator, by their numbers in the run.
struct HomeRange {
  int first = 0, count = 0;
  bool operator==(const HomeRange&) const = default;
};
using BlockHomes = std::array<HomeRange, kSimulators.size()>;  // in the order of kSimulators

/// A part of a run that depends on no other: slots that are filled in homes of their own and balanced among themselves.
/// Its result does not depend on which process fills it or when, so shards are made of blocks, and memory is bounded by
/// them. Tasks of two blocks never repeat one another, since the blocks share no home.
struct Block {
  std::vector<TaskSlot> slots;  // consecutive, not empty
  BlockHomes homes;
  int first() const { return slots.front().index; }
};

/// The slots, in order, cut into blocks of about `configuration.block`; with given homes or those of the benchmark, at
/// most so many that each block has a home of every simulator. Of new homes there is one for every five tasks of a
/// simulator's first fifty and one for every 25 more, so that making them does not dominate a large run. Deterministic.
std::vector<Block> blocks_of(const RunConfiguration& configuration, const Resources& resources,
                             const std::vector<TaskSlot>& slots);

}  // namespace unietp
