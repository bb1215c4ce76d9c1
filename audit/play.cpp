#include "audit/play.h"

#include <cstddef>

namespace unietp {
namespace {

/// The option with the highest value; of equals, one at random.
std::size_t guess_of(const ShortcutPolicy& policy, const std::vector<GuessOption>& options, const ModelsOfPart& models,
                     std::vector<float>& values, Rng& rng) {
  values.clear();
  for (const GuessOption& option : options) values.push_back(policy.value(option, models));
  float best = values.front();
  std::size_t equals = 0;
  for (const float value : values) {
    if (value > best) best = value, equals = 0;
    if (value == best) ++equals;
  }
  std::size_t left = equals == 1 ? 0 : rng.below(equals);
  for (std::size_t i = 0;; ++i) {
    if (values[i] == best && left-- == 0) return i;
  }
}

}  // namespace

std::vector<Guesses> play(const GuessQuestion& question, const std::vector<const ShortcutPolicy*>& policies,
                          const ModelsOfPart& models, const KindPool& pool, Rng rng) {
  std::vector<Guesses> guesses(policies.size());
  std::vector<GuessOption> options = question.options;
  std::vector<float> values;
  values.reserve(options.size());
  Shuffler shuffler(question.options, *policies.front()->channel, pool);
  for (std::size_t arrangement = 0; arrangement <= kPermutations; ++arrangement) {
    if (arrangement > 0) shuffler.draw(rng, options);
    for (std::size_t p = 0; p < policies.size(); ++p)
      guesses[p][arrangement] = question.right[guess_of(*policies[p], options, models, values, rng)];
  }
  return guesses;
}

}  // namespace unietp
