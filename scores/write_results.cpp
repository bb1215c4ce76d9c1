#include "scores/write_results.h"

#include <algorithm>
#include <map>
#include <set>

#include <nlohmann/json.hpp>

#include "core/file_digest.h"
#include "core/files.h"
#include "scores/episode_view.h"
#include "scores/evaluation_page.h"
#include "scores/result_files.h"

namespace unietp {
namespace {

constexpr int kPictureWidth = 320;  // pixels

/// Which episodes get pictures: one after the other of each mode, split and result.
Result<std::set<EpisodeKey>> pictured_episodes(const std::filesystem::path& folder, int count) {
  std::map<std::tuple<Mode, std::string, bool>, std::vector<EpisodeKey>> groups;
  const auto read = for_each_episode(folder, [&](int, EpisodeRecord&& episode) -> Result<Done> {
    auto& group = groups[{episode.key.mode, episode.split, episode.success}];
    if (static_cast<int>(group.size()) < count) group.push_back(std::move(episode.key));
    return Done{};
  });
  if (!read) return read.error();
  std::set<EpisodeKey> chosen;
  for (std::size_t round = 0; static_cast<int>(chosen.size()) < count; ++round) {
    bool any = false;
    for (const auto& [name, group] : groups) {
      if (round >= group.size() || static_cast<int>(chosen.size()) >= count) continue;
      chosen.insert(group[round]);
      any = true;
    }
    if (!any) break;
  }
  return chosen;
}

Error disagreement(const std::filesystem::path& folder, const ScoringDifference& one) {
  return {Error::Kind::Schema,
          (folder / kEpisodesFile).string() + "#" + one.difference.pointer,
          {one.line, 0},
          "task " + one.key.task + ": recorded is " + one.difference.recorded + ", but its replies lead to " +
              one.difference.replayed};
}

struct MadeResults {
  ScoredRun run;
  std::map<std::string, std::string> files;
  std::vector<Error> disagreements;
};

Result<MadeResults> make_results(const std::filesystem::path& folder, const ScoringData& data,
                                 const ResultsOptions& options) {
  const auto pictured = pictured_episodes(folder, options.pictured);
  if (!pictured) return pictured.error();
  MadeResults made;
  std::vector<std::string> views;
  ScoringWatch watch;
  watch.pictures = [&](const EpisodeKey& key) { return pictured->contains(key) ? kPictureWidth : 0; };
  watch.view = [&](std::string&& view) { views.push_back(std::move(view)); };
  watch.differ = [&](const ScoringDifference& one) { made.disagreements.push_back(disagreement(folder, one)); };
  auto run = score_run(folder, data, watch);
  if (!run) return run.error();
  made.run = std::move(*run);
  const auto manifest = digest_of_file(folder, kEvaluationManifest);
  if (!manifest) return manifest.error();
  made.files = result_files(made.run, manifest->sha256);
  made.files[kReportFile] = evaluation_page(made.run, views);
  return made;
}

/// Where two texts first differ: line and column.
SourcePos first_difference(const std::string& a, const std::string& b) {
  const auto end = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
  return locate(a, static_cast<std::size_t>(end.first - a.begin()));
}

void check_totals(const ScoredRun& run, const std::string& where, std::vector<Error>& found) {
  const EvaluationTotals& stated = run.manifest.totals;
  EvaluationTotals real;
  for (const EpisodeScore& one : run.scores) {
    (one.errored() ? real.errored : real.finished) += 1;
    real.prompt_tokens += one.prompt_tokens;
    real.completion_tokens += one.completion_tokens;
  }
  const auto compare = [&](const char* name, std::int64_t said, std::int64_t is) {
    if (said != is)
      found.push_back({Error::Kind::Schema,
                       where + "#/totals/" + name,
                       {},
                       "is " + std::to_string(said) + ", but the episodes have " + std::to_string(is)});
  };
  compare("finished", stated.finished, real.finished);
  compare("errored", stated.errored, real.errored);
  compare("prompt_tokens", stated.prompt_tokens, real.prompt_tokens);
  compare("completion_tokens", stated.completion_tokens, real.completion_tokens);
  if (stated.episodes < static_cast<int>(run.scores.size()))
    found.push_back(
        {Error::Kind::Schema, where + "#/totals/episodes", {}, "there are more episodes than were asked for"});
}

}  // namespace

Result<ScoredRun> write_results(const std::filesystem::path& folder, const ScoringData& data,
                                const ResultsOptions& options) {
  auto made = make_results(folder, data, options);
  if (!made) return made.error();
  if (!made->disagreements.empty()) return made->disagreements.front();
  for (const auto& [name, text] : made->files) {
    if (auto done = write_file(folder, name, text); !done) return done.error();
  }
  return std::move(made->run);
}

std::vector<Error> check_results(const std::filesystem::path& folder, const ScoringData& data,
                                 const ResultsOptions& options) {
  std::vector<Error> found;
  const auto made = make_results(folder, data, options);
  if (!made) return {made.error()};
  const std::string manifest = (folder / kEvaluationManifest).string();
  for (const char* name : {kEpisodesFile, kTimingFile}) {
    const auto digest = digest_of_file(folder, name);
    const auto stated = made->run.manifest.files.find(name);
    if (!digest) {
      found.push_back(digest.error());
    } else if (stated == made->run.manifest.files.end() || stated->second != digest->sha256) {
      found.push_back(
          {Error::Kind::Schema, (folder / name).string(), {}, "is not the file whose SHA-256 the manifest has"});
    }
  }
  check_totals(made->run, manifest, found);
  found.insert(found.end(), made->disagreements.begin(), made->disagreements.end());
  for (const auto& [name, text] : made->files) {
    const auto there = read_file(folder, name);
    if (!there) {
      found.push_back(there.error());
    } else if (*there != text) {
      found.push_back({Error::Kind::Schema, (folder / name).string(), first_difference(*there, text),
                       "is not what follows from the episodes"});
    }
  }
  return found;
}

}  // namespace unietp
