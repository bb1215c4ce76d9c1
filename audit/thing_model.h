#pragma once

#include <array>
#include <vector>

#include "audit/guess.h"
#include "audit/text_rank.h"

namespace unietp {

/// How likely an option is right, by logistic regression: one weight for each kind and for each range of each field,
/// learned by gradient steps over the questions of one choice, in order. Equal examples give equal weights.
class ThingModel {
 public:
  ThingModel() : weights_(kWeights, 0) {}
  /// Learns from the questions of homes outside of `part`.
  ThingModel(const std::vector<AuditedTask>& examples, GuessChoice choice, std::size_t part);
  /// The larger, the likelier.
  float value(const GuessOption& option) const;

 private:
  static constexpr std::size_t kWeights = 1U << 14;
  static constexpr std::size_t kFeatures = 12;
  static std::array<std::uint32_t, kFeatures> features(const GuessOption& option);

  std::vector<float> weights_;
};

/// Models for the questions of each part of the homes.
struct LearnedModels {
  std::array<ThingModel, kHomeParts> small_things, of_kind;
};
LearnedModels learn_models(const std::vector<AuditedTask>& examples);

}  // namespace unietp
