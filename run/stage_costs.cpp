#include "run/stage_costs.h"

namespace unietp {

std::string_view name_of(Stage stage) {
  static constexpr std::array<std::string_view, kStageCount> kNames{"homes",   "planning",  "generator", "grounding",
                                                                    "expert",  "mutations", "annotator", "other_modes",
                                                                    "writing", "ledger",    "dataset"};
  return kNames[static_cast<std::size_t>(stage)];
}

void StageCosts::add(const StageCosts& other) {
  for (std::size_t i = 0; i < kStageCount; ++i) seconds[i] += other.seconds[i];
}

void StageTimer::add_elapsed() {
  const auto now = Clock::now();
  if (costs_ != nullptr)
    costs_->seconds[static_cast<std::size_t>(stage_)] += std::chrono::duration<double>(now - start_).count();
  start_ = now;
}

}  // namespace unietp
