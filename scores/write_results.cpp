#include "scores/write_results.h"

#include <algorithm>
#include <map>
#include <set>

#include "core/file_digest.h"
#include "core/files.h"
#include "core/in_quotes.h"
#include "core/text.h"
#include "scores/evaluation_page.h"
#include "scores/report_pages.h"
#include "scores/result_files.h"

namespace unietp {
namespace {

constexpr int kPictureWidth = 320;  // pixels

Error disagreement(const std::filesystem::path& folder, const ScoringDifference& one) {
  return {Error::Kind::Schema,
          (folder / kEpisodesFile).string() + "#" + one.difference.pointer,
          {one.line, 0},
          "task " + one.key.task + ": recorded is " + one.difference.recorded + ", but its replies lead to " +
              one.difference.replayed};
}

struct MadeResults {
  ScoredRun run;
  std::map<std::string, std::string> files;  // but for the pages of the report
  std::vector<Error> disagreements;
};

/// `page` takes the pages of the report while they are made.
Result<MadeResults> make_results(const std::filesystem::path& folder, const ScoringData& data,
                                 const ReportPages::Take& page) {
  MadeResults made;
  ReportPages pages(page);
  ScoringCallbacks watch;
  watch.picture_width = kPictureWidth;
  watch.view = [&](std::string&& view) { return pages.add(view); };
  watch.differ = [&](const ScoringDifference& one) { made.disagreements.push_back(disagreement(folder, one)); };
  auto run = score_run(folder, data, watch);
  if (!run) return run.error();
  if (auto done = pages.finish(); !done) return done.error();
  made.run = std::move(*run);
  const auto manifest = digest_of_file(folder, kEvaluationManifest);
  if (!manifest) return manifest.error();
  made.files = result_files(made.run, manifest->sha256);
  made.files[kReportFile] = evaluation_page(made.run);
  return made;
}

/// Where two texts first differ: line and column.
SourcePos first_difference(const std::string& a, const std::string& b) {
  const auto end = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
  return locate(a, static_cast<std::size_t>(end.first - a.begin()));
}

/// Whether the totals of the manifest are those of the episodes. `models`: that the episodes name.
void check_totals(const ScoredRun& run, const std::set<std::string>& models, const std::string& where,
                  std::vector<Error>& found) {
  const EvaluationTotals& stated = run.manifest.totals;
  EvaluationTotals real;
  for (const EpisodeScore& one : run.scores) {
    (one.errored() ? real.errored : real.finished) += 1;
    real.prompt_tokens += one.prompt_tokens;
    real.completion_tokens += one.completion_tokens;
    real.cost += one.cost;
  }
  const auto compare = [&](const char* name, const auto& said, const auto& is, const auto& text) {
    if (said != is)
      found.push_back({Error::Kind::Schema,
                       where + "#/totals/" + name,
                       {},
                       "is " + text(said) + ", but the episodes have " + text(is)});
  };
  const auto whole = [](std::int64_t number) { return std::to_string(number); };
  compare("finished", stated.finished, real.finished, whole);
  compare("errored", stated.errored, real.errored, whole);
  compare("prompt_tokens", stated.prompt_tokens, real.prompt_tokens, whole);
  compare("completion_tokens", stated.completion_tokens, real.completion_tokens, whole);
  compare("cost", stated.cost, real.cost, [](double number) { return number_text(number); });
  compare("models", stated.models, std::vector<std::string>(models.begin(), models.end()),
          [](const std::vector<std::string>& names) { return names.empty() ? "none" : in_quotes(join(names, ", ")); });
  if (stated.episodes < static_cast<int>(run.scores.size()))
    found.push_back(
        {Error::Kind::Schema, where + "#/totals/episodes", {}, "there are more episodes than were asked for"});
}

Result<std::set<std::string>> models_of(const std::filesystem::path& folder) {
  std::set<std::string> models;
  const auto read = for_each_episode(folder, [&](int, EpisodeRecord&& episode) -> Result<Done> {
    models.insert(episode.models.begin(), episode.models.end());
    return Done{};
  });
  if (!read) return read.error();
  return models;
}

/// Pages that no episode of the run is in.
void check_pages(const std::filesystem::path& folder, const std::set<std::string>& made, std::vector<Error>& found) {
  std::error_code failed;
  for (std::filesystem::directory_iterator entry(folder / kReportFolder, failed), end; !failed && entry != end;
       entry.increment(failed)) {
    const std::string name = std::string(kReportFolder) + "/" + entry->path().filename().string();
    if (!made.contains(name))
      found.push_back({Error::Kind::Schema, (folder / name).string(), {}, "belongs to no episode of the run"});
  }
}

}  // namespace

Result<ScoredRun> write_results(const std::filesystem::path& folder, const ScoringData& data) {
  std::error_code failed;
  std::filesystem::remove_all(folder / kReportFolder, failed);
  if (failed) return Error{Error::Kind::Io, (folder / kReportFolder).string(), {}, failed.message()};
  auto made = make_results(
      folder, data, [&](const std::string& name, const std::string& page) { return write_file(folder, name, page); });
  if (!made) return made.error();
  if (!made->disagreements.empty()) return made->disagreements.front();
  for (const auto& [name, text] : made->files) {
    if (auto done = write_file(folder, name, text); !done) return done.error();
  }
  return std::move(made->run);
}

std::vector<Error> check_results(const std::filesystem::path& folder, const ScoringData& data) {
  std::vector<Error> found, unlike;
  std::set<std::string> pages;
  const auto compare = [&](const std::string& name, const std::string& text) -> Result<Done> {
    pages.insert(name);
    const auto there = read_file(folder, name);
    if (!there) {
      unlike.push_back(there.error());
    } else if (*there != text) {
      unlike.push_back({Error::Kind::Schema, (folder / name).string(), first_difference(*there, text),
                        "is not what follows from the episodes"});
    }
    return Done{};
  };
  const auto made = make_results(folder, data, compare);
  if (!made) return {made.error()};
  check_pages(folder, pages, unlike);
  for (const auto& [name, text] : made->files) (void)compare(name, text);
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
  const auto models = models_of(folder);
  if (!models) return {models.error()};
  check_totals(made->run, *models, manifest, found);
  found.insert(found.end(), made->disagreements.begin(), made->disagreements.end());
  found.insert(found.end(), unlike.begin(), unlike.end());
  return found;
}

}  // namespace unietp
