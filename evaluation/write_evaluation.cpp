#include <algorithm>
#include <utility>

#include "core/file_digest.h"
#include "core/file_writer.h"
#include "core/files.h"
#include "evaluation/evaluate.h"

namespace unietp {
namespace {

Result<Done> write_lines(const std::filesystem::path& folder, const EpisodePlan& plan, const EpisodeLog& log) {
  auto episodes_place = place_of(folder / kEpisodesFile);
  if (!episodes_place) return episodes_place.error();
  auto timing_place = place_of(folder / kTimingFile);
  if (!timing_place) return timing_place.error();
  auto episodes = FileWriter::replace(std::move(*episodes_place));
  if (!episodes) return episodes.error();
  auto timing = FileWriter::replace(std::move(*timing_place));
  if (!timing) return timing.error();
  for (const PlannedEpisode& planned : plan.episodes) {
    const auto ended = log.ended(planned.key);
    if (!ended) continue;
    const auto lines = log.lines_of(*ended);
    if (!lines) return lines.error();
    if (auto done = timing->add(lines->first); !done) return done;
    if (auto done = episodes->add(lines->second); !done) return done;
  }
  if (auto done = timing->finish(); !done) return done;
  return episodes->finish();
}

EvaluationTotals totals_of(const EpisodePlan& plan, const EpisodeLog& log) {
  EvaluationTotals totals;
  totals.episodes = static_cast<int>(plan.episodes.size());
  for (const PlannedEpisode& planned : plan.episodes) {
    const auto ended = log.ended(planned.key);
    if (!ended) continue;
    (ended->errored ? totals.errored : totals.finished) += 1;
    totals.models.insert(totals.models.end(), ended->models.begin(), ended->models.end());
    totals.prompt_tokens += ended->prompt_tokens;
    totals.completion_tokens += ended->completion_tokens;
    totals.cost += ended->cost;
  }
  std::sort(totals.models.begin(), totals.models.end());
  totals.models.erase(std::unique(totals.models.begin(), totals.models.end()), totals.models.end());
  return totals;
}

}  // namespace

Result<EvaluationManifest> write_evaluation(const std::filesystem::path& folder, const EvaluationSetup& setup,
                                            const EpisodePlan& plan, const EpisodeLog& log, int report_pictures) {
  if (auto done = write_lines(folder, plan, log); !done) return done.error();
  EvaluationManifest manifest{setup, totals_of(plan, log), {}, report_pictures};
  for (const char* name : {kEpisodesFile, kTimingFile}) {
    const auto digest = digest_of_file(folder, name);
    if (!digest) return digest.error();
    manifest.files[name] = digest->sha256;
  }
  if (auto done = write_file(folder / kEvaluationManifest, to_text(manifest)); !done) return done.error();
  return manifest;
}

}  // namespace unietp
