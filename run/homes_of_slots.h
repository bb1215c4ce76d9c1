#pragma once

#include <string_view>
#include <utility>
#include <vector>

#include "core/result.h"
#include "dataset/configuration.h"
#include "resources/resources.h"
#include "run/blocks.h"

namespace unietp {

/// In which homes a run fills which slots (blocks.h), for whoever holds a finished task against its run. Of a run that
/// is given no homes.
class HomesOfSlots {
 public:
  /// Errors: those of plan_slots.
  static Result<HomesOfSlots> of(const RunConfiguration& configuration, const Resources& resources);

  /// Whether the slot of this number may be filled in the home of this name.
  bool may_fill(int slot, std::string_view home) const;

 private:
  HomesOfSlots(RunConfiguration configuration, const Resources& resources, std::vector<Block> blocks)
      : configuration_(std::move(configuration)), resources_(resources), blocks_(std::move(blocks)) {}

  RunConfiguration configuration_;
  const Resources& resources_;
  std::vector<Block> blocks_;
};

}  // namespace unietp
