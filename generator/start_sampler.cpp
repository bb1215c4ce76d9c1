#include "generator/start_sampler.h"

#include "generator/start_draft.h"

namespace unietp {
namespace {

constexpr int kDrafts = 8;     // fresh starts before giving up
constexpr int kRepairs = 200;  // changes tried in one draft

}  // namespace

std::optional<SymbolicStart> StartSampler::sample(Rng rng) const {
  for (int i = 0; i < kDrafts; ++i) {
    StartDraft draft(demands_, rng);
    for (int repair = 0; repair < kRepairs && draft.improve(); ++repair) {
    }
    if (draft.sound()) return std::move(draft).finished();
  }
  return std::nullopt;
}

}  // namespace unietp
