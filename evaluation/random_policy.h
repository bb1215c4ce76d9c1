#pragma once

#include "core/rng.h"
#include "evaluation/policy.h"

namespace unietp {

/// The stream of draws of an episode, which depends only on these.
Rng episode_rng(std::uint64_t seed, const EpisodeKey& key);

/// Acts at random, as an agent could that has read what it is told: each action that the mode and the simulator offer
/// is as likely as any other, on any thing that it knows of; `stop` in one of fifty replies. Where objects are named by
/// boxes, the boxes are drawn too.
class RandomPolicy : public Policy {
 public:
  explicit RandomPolicy(std::uint64_t seed) : seed_(seed) {}
  std::optional<NoReply> begin(const PlannedEpisode& episode, const Environment& start) override;
  PolicyAnswer next(const Environment& environment) override;

 private:
  std::uint64_t seed_;
  Rng rng_{0};
};

}  // namespace unietp
