#include "audit/thing_model.h"

#include <algorithm>
#include <cmath>

namespace unietp {
namespace {

constexpr int kModelPasses = 4;
constexpr float kModelRate = 0.1F;

std::uint32_t range_of(float share, std::uint32_t ranges) {
  return std::min(ranges - 1, static_cast<std::uint32_t>(std::max(0.0F, share) * static_cast<float>(ranges)));
}

}  // namespace

std::array<std::uint32_t, ThingModel::kFeatures> ThingModel::features(const GuessOption& option) {
  constexpr std::uint32_t kRange = 16;  // values of a feature that is no kind
  const std::uint32_t values[] = {
      range_of(option.place, kRange),  option.place == 0 ? 0U : option.place == 1 ? 1U : 2U,
      range_of(option.number_rank, 5), range_of(option.odd_count, 5),
      range_of(option.more, 5),        range_of(option.odd_states, 8),
      range_of(option.odd_support, 8), range_of(option.odd_room, 8),
      range_of(option.odd_asset, 4),   std::min(3U, static_cast<std::uint32_t>(option.alike))};
  std::array<std::uint32_t, kFeatures> at{};
  for (std::uint32_t i = 0; i < std::size(values); ++i) at[i] = i * kRange + values[i];
  constexpr std::uint32_t kFixed = std::size(values) * kRange;
  static_assert(std::size(values) + 2 == kFeatures && kFixed < kWeights);
  at[kFeatures - 2] = kFixed + static_cast<std::uint32_t>(option.kind % (kWeights - kFixed));
  at[kFeatures - 1] = kFixed + static_cast<std::uint32_t>((option.room_type ^ 7) % (kWeights - kFixed));
  return at;
}

float ThingModel::value(const GuessOption& option) const {
  float sum = 0;
  for (const std::uint32_t at : features(option)) sum += weights_[at];
  return sum;
}

ThingModel::ThingModel(const std::vector<AuditedTask>& examples, GuessChoice choice, std::size_t part) : ThingModel() {
  for (int pass = 0; pass < kModelPasses; ++pass) {
    for (const AuditedTask& task : examples) {
      if (part_of(task) == part) continue;
      for (const GuessQuestion& question : task.questions) {
        if (question.choice != choice) continue;
        for (std::size_t i = 0; i < question.options.size(); ++i) {
          const auto chance = static_cast<float>(1 / (1 + std::exp(-static_cast<double>(value(question.options[i])))));
          const float step = kModelRate * ((question.right[i] ? 1.0F : 0.0F) - chance);
          for (const std::uint32_t at : features(question.options[i])) weights_[at] += step;
        }
      }
    }
  }
}

LearnedModels learn_models(const std::vector<AuditedTask>& examples) {
  LearnedModels models;
  for (std::size_t part = 0; part < kHomeParts; ++part) {
    models.small_things[part] = ThingModel(examples, GuessChoice::SmallThing, part);
    models.of_kind[part] = ThingModel(examples, GuessChoice::OfKind, part);
  }
  return models;
}

}  // namespace unietp
