#pragma once

#include "evaluation/episode_record.h"
#include "evaluation/evaluation_manifest.h"

namespace unietp {

/// Records with every field set.
EpisodeRecord sample_episode();
EpisodeRecord errored_episode();
TimingRecord sample_timing();
EvaluationManifest sample_manifest();

}  // namespace unietp
