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

/// A part of a run that depends on no other: slots that are filled in homes of their own, level in themselves. What a
/// block becomes is the same whoever makes it and when. So blocks are what shards share out and what bounds memory;
/// tasks of two blocks never repeat one another, since they share no home.
struct Block {
  std::vector<TaskSlot> slots;  // consecutive, not empty
  BlockHomes homes;
  int first() const { return slots.front().index; }
};

/// The slots, in order, cut into blocks of about `configuration.block`; as many as leave each a home of every simulator
/// when homes are given or the benchmark's. Of new homes there is one for each five tasks of a simulator's first fifty
/// and one for each 25 more, so that making them does not dominate a large run. Deterministic.
std::vector<Block> blocks_of(const RunConfiguration& configuration, const Resources& resources,
                             const std::vector<TaskSlot>& slots);

}  // namespace unietp
