#include "scores/scored_run.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "core/file_digest.h"
#include "core/files.h"
#include "core/in_quotes.h"
#include "core/ordered_work.h"
#include "record/line_file.h"
#include "scores/bootstrap.h"

namespace unietp {
namespace {

std::string name_of_folder(const std::filesystem::path& folder) {
  const auto whole = std::filesystem::absolute(folder).lexically_normal();
  return (whole.has_filename() ? whole : whole.parent_path()).filename().string();
}

Result<EvaluationManifest> manifest_of(const std::filesystem::path& folder) {
  const auto text = read_file(folder, kEvaluationManifest);
  if (!text) return text.error();
  return read_evaluation_manifest((folder / kEvaluationManifest).string(), *text);
}

/// One line after the other of a file of JSON lines. A last line that was cut is no line.
template <class Record>
Result<Done> for_each_line(const std::filesystem::path& folder, const char* name,
                           Result<Record> (*read)(std::string_view, int, std::string_view),
                           const std::function<Result<Done>(int, Record&&)>& take) {
  auto file = LineFile::open(folder, name, FileNames::WithFolder);
  if (!file) return file.error();
  while (const auto line = file->next()) {
    if (!line->fault.empty())
      return Error{Error::Kind::Parse, file->name(), {line->number, 1}, "the line " + line->fault};
    auto record = read(file->name(), line->number, line->text);
    if (!record) return record.error();
    if (const auto taken = take(line->number, std::move(*record)); !taken) return taken.error();
  }
  return Done{};
}

/// What has to be known of all episodes of a run before the first is scored.
struct RunOutline {
  std::map<std::pair<std::string, Mode>, int> fewest;  // by task and mode: the fewest steps of a success
  std::set<EpisodeKey> pictured;                       // episodes whose view has pictures
};

/// Up to `count` episodes, one after the other of each group.
template <class Groups>
std::set<EpisodeKey> spread_over(const Groups& groups, std::size_t count) {
  std::set<EpisodeKey> chosen;
  for (std::size_t round = 0; chosen.size() < count; ++round) {
    bool any = false;
    for (const auto& [name, group] : groups) {
      if (round >= group.size() || chosen.size() >= count) continue;
      chosen.insert(group[round]);
      any = true;
    }
    if (!any) break;
  }
  return chosen;
}

Result<RunOutline> outline_of(const std::filesystem::path& folder, int pictured) {
  RunOutline outline;
  const auto most = static_cast<std::size_t>(std::max(0, pictured));
  std::map<std::tuple<Mode, std::string, bool>, std::vector<EpisodeKey>> groups;
  const auto read = for_each_episode(folder, [&](int, EpisodeRecord&& episode) -> Result<Done> {
    if (episode.success) {
      const auto [entry, added] = outline.fewest.try_emplace({episode.key.task, episode.key.mode}, episode.counted);
      if (!added) entry->second = std::min(entry->second, episode.counted);
    }
    auto& group = groups[{episode.key.mode, episode.split, episode.success}];
    if (group.size() < most) group.push_back(std::move(episode.key));
    return Done{};
  });
  if (!read) return read.error();
  outline.pictured = spread_over(groups, most);
  return outline;
}

/// The fewest steps of a success of the run at the task of an episode in its mode.
std::optional<int> fewest_steps(const EpisodeKey& key, const RunOutline& outline) {
  const auto own = outline.fewest.find({key.task, key.mode});
  return own == outline.fewest.end() ? std::nullopt : std::optional(own->second);
}

struct Scored {
  EpisodeScore score;
  std::string view;
  std::vector<ScoringDifference> differences;
};

/// Scores the episodes of a run, from several threads.
struct Scorer {
  const EvaluationManifest& manifest;
  const ScoringData& data;
  const RunOutline& outline;
  int picture_width;

  Result<Scored> score(int line, const EpisodeRecord& record) const {
    const bool pictured = picture_width > 0 && outline.pictured.contains(record.key);
    Scored scored;
    std::optional<JudgedEpisode> judged;
    if (data.watched != nullptr && !pictured) {
      auto kept = data.watched->find(record.key);
      if (!kept) return kept.error();
      judged = std::move(*kept);
    }
    if (!judged) {
      auto again = judge_again(line, record, pictured, scored.differences);
      if (!again) return again.error();
      judged = std::move(*again);
    }
    scored.score = finalize_score(std::move(judged->score), fewest_steps(record.key, outline));
    scored.view = std::move(judged->view);
    return scored;
  }

 private:
  Result<JudgedEpisode> judge_again(int line, const EpisodeRecord& record, bool pictured,
                                    std::vector<ScoringDifference>& found) const {
    const auto task = data.judging.tasks.task(record.key.task);
    if (!task) return task.error();
    const auto settings = manifest.setup.settings.find(record.key.mode);
    if (settings == manifest.setup.settings.end())
      return Error{Error::Kind::Schema,
                   std::string(kEpisodesFile) + "#/mode",
                   {line, 0},
                   "the manifest has no settings of this mode"};
    const bool in_simulator = std::any_of(record.steps.begin(), record.steps.end(), [](const EpisodeStep& step) {
      return std::any_of(step.actions.begin(), step.actions.end(), [](const auto& one) { return one.simulator; });
    });
    if (in_simulator && manifest.setup.backend == kOwnBackend)
      return Error{Error::Kind::Schema,
                   std::string(kEpisodesFile) + "#/steps",
                   {line, 0},
                   "has what a simulator said, but the manifest's backend is unietp"};
    EpisodePictures pictures;
    WatchEpisode look;
    if (pictured)
      look = [&](std::size_t, const Environment& now) { pictures.push_back(view_picture(now, picture_width)); };
    const auto replayed = replay_episode(record, *task, settings->second, look);
    if (!replayed) return replayed.error();
    for (EpisodeDifference& one : differences(record, *replayed, **task))
      found.push_back({line, record.key, std::move(one)});
    return judge_episode(record, *replayed, **task, data.judging, pictures);
  }
};

Result<std::map<Mode, LatencyFigures>> latency_of(const std::filesystem::path& folder) {
  std::map<Mode, LatencyFigures> figures;
  if (!std::filesystem::exists(folder / kTimingFile)) return figures;
  std::map<Mode, std::vector<double>> times;
  const auto read =
      for_each_line<TimingRecord>(folder, kTimingFile, read_timing, [&](int, TimingRecord&& timing) -> Result<Done> {
        for (std::size_t i = 0; i < timing.reply_s.size(); ++i) {
          if (i < timing.attempts.size() && timing.attempts[i] > 0) times[timing.key.mode].push_back(timing.reply_s[i]);
        }
        return Done{};
      });
  if (!read) return read.error();
  for (auto& [mode, list] : times) {
    std::sort(list.begin(), list.end());
    LatencyFigures& one = figures[mode];
    one.replies = static_cast<int>(list.size());
    for (const double seconds : list) one.total += seconds;
    one.mean = one.total / one.replies;
    one.median = quantile_of(list, 0.5);
    one.percentile_95 = quantile_of(list, 0.95);
  }
  return figures;
}

/// A field in which a score is not what its episode says, or "".
std::string field_unlike(const EpisodeScore& score, const EpisodeRecord& episode) {
  EpisodeScore said;
  said.replies = static_cast<int>(episode.steps.size());
  for (const EpisodeStep& step : episode.steps) {
    said.actions += static_cast<int>(step.actions.size());
    said.prompt_tokens += step.prompt_tokens;
    said.completion_tokens += step.completion_tokens;
    said.cost += step.cost;
  }
  if (score.key != episode.key) return "task";
  if (score.simulator != episode.simulator) return "simulator";
  if (score.split != episode.split) return "split";
  if (score.template_name != episode.template_name) return "template";
  if (score.layout != episode.layout) return "layout";
  if (score.end != episode.end) return "end";
  if (score.success != episode.success) return "success";
  if (score.progress != episode.progress) return "progress";
  if (score.steps != episode.counted) return "steps";
  if (score.failures != episode.failures) return "failures";
  if (score.replies != said.replies) return "replies";
  if (score.actions != said.actions) return "actions";
  if (score.prompt_tokens != said.prompt_tokens) return "prompt_tokens";
  if (score.completion_tokens != said.completion_tokens) return "completion_tokens";
  if (score.cost != said.cost) return "cost";
  return "";
}

/// Whether the scores are those of the episodes, and the episodes those of the manifest. What a score says beyond its
/// episode's own fields is left to `validate`, which executes the episodes again.
Result<Done> check_scores(const std::filesystem::path& folder, const ScoredRun& run) {
  const auto stale = [&](const char* file, int line, const std::string& message) {
    return Error{Error::Kind::Schema,
                 (folder / file).string(),
                 {line, 0},
                 message + "; `unietp evaluate --resume` writes the results anew"};
  };
  const auto digest = digest_of_file(folder, kEpisodesFile);
  if (!digest) return digest.error();
  const auto stated = run.manifest.files.find(kEpisodesFile);
  if (stated == run.manifest.files.end() || stated->second != digest->sha256)
    return stale(kEpisodesFile, 0, "is not the file whose SHA-256 the manifest has");
  std::size_t next = 0;
  const auto read = for_each_episode(folder, [&](int line, EpisodeRecord&& episode) -> Result<Done> {
    if (next >= run.scores.size()) return stale(kScoresFile, 0, "has fewer lines than " + std::string(kEpisodesFile));
    const std::string field = field_unlike(run.scores[next++], episode);
    if (field.empty()) return Done{};
    return stale(kScoresFile, line, "its " + field + " is not that of the episode in " + std::string(kEpisodesFile));
  });
  if (!read) return read.error();
  if (next < run.scores.size()) return stale(kScoresFile, 0, "has more lines than " + std::string(kEpisodesFile));
  return Done{};
}

Result<ScoredRun> run_without_scores(const std::filesystem::path& folder) {
  ScoredRun run;
  run.name = name_of_folder(folder);
  auto manifest = manifest_of(folder);
  if (!manifest) return manifest.error();
  run.manifest = std::move(*manifest);
  auto latency = latency_of(folder);
  if (!latency) return latency.error();
  run.latency = std::move(*latency);
  return run;
}

}  // namespace

int ScoredRun::missing() const { return std::max(0, manifest.totals.episodes - static_cast<int>(scores.size())); }

bool ScoredRun::complete() const {
  return missing() == 0 && std::none_of(scores.begin(), scores.end(), [](const auto& one) { return one.errored(); });
}

Result<Done> for_each_episode(const std::filesystem::path& folder,
                              const std::function<Result<Done>(int line, EpisodeRecord&& episode)>& take) {
  return for_each_line<EpisodeRecord>(folder, kEpisodesFile, read_episode, take);
}

Result<ScoredRun> score_run(const std::filesystem::path& folder, const ScoringData& data,
                            const ScoringCallbacks& watch) {
  auto run = run_without_scores(folder);
  if (!run) return run.error();
  const auto outline = outline_of(folder, run->manifest.report_pictures);
  if (!outline) return outline.error();
  const Scorer scorer{run->manifest, data, *outline, watch.picture_width};
  auto file = LineFile::open(folder, kEpisodesFile, FileNames::WithFolder);
  if (!file) return file.error();
  const auto done = work_in_order<FileLine, Result<Scored>>(
      data.threads, [&] { return file->next(); },
      [&](const FileLine& line) -> Result<Scored> {
        const auto record = read_episode(file->name(), line.number, line.text);
        return record ? scorer.score(line.number, *record) : Result<Scored>(record.error());
      },
      [&](Result<Scored>&& scored) -> Result<Done> {
        if (!scored) return scored.error();
        for (const ScoringDifference& one : scored->differences) {
          if (watch.differ) watch.differ(one);
        }
        run->scores.push_back(std::move(scored->score));
        return watch.view ? watch.view(std::move(scored->view)) : Result<Done>(Done{});
      });
  if (!done) return done.error();
  return run;
}

Result<ScoredRun> read_scored_run(const std::filesystem::path& folder) {
  if (!std::filesystem::is_directory(folder))
    return Error{Error::Kind::Usage, folder.string(), {}, "expected the folder of an evaluation"};
  auto run = run_without_scores(folder);
  if (!run) return run.error();
  if (!std::filesystem::exists(folder / kScoresFile))
    return Error{Error::Kind::Usage,
                 folder.string(),
                 {},
                 std::string("has no ") + kScoresFile + "; `unietp evaluate --resume` writes it"};
  const auto read = for_each_line<EpisodeScore>(folder, kScoresFile, read_score, [&](int, EpisodeScore&& score) {
    run->scores.push_back(std::move(score));
    return Result<Done>(Done{});
  });
  if (!read) return read.error();
  if (const auto fine = check_scores(folder, *run); !fine) return fine.error();
  return run;
}

}  // namespace unietp
