#include "rewording/apply_review.h"

#include <map>
#include <optional>

#include <nlohmann/json.hpp>

#include "core/changed_copy.h"
#include "core/files.h"
#include "core/sqlite_file.h"
#include "core/text.h"
#include "dataset/configuration_json.h"
#include "dataset/dataset_writer.h"
#include "dataset/instruction_json.h"
#include "rewording/review_rulings.h"
#include "rewording/task_lines.h"
#include "validator/folder_reading.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

const std::string kReviews = "reviews.jsonl", kPairs = "wordings.jsonl", kManifest = "manifest.json";

Result<Json> read_json(const fs::path& file) {
  const auto text = read_file(file);
  if (!text) return text.error();
  auto json = Json::parse(*text, nullptr, false);
  if (!json.is_object()) return Error{Error::Kind::Parse, file.string(), {1, 1}, "expected a JSON object"};
  return json;
}

/// "" for what is no object with such a text.
std::string text_in(const Json& json, const std::string& field) {
  const auto* text = json.is_object() && json.contains(field) ? json.at(field).get_ptr<const std::string*>() : nullptr;
  return text == nullptr ? "" : *text;
}

/// The lines of a file, none of one that is not there; by the task that the field names.
Result<std::map<std::string, std::string>> lines_by_task(const fs::path& folder, const std::string& name,
                                                         const char* field) {
  const auto file = LineFile::read(folder, name);
  if (!file) return file.error();
  std::map<std::string, std::string> lines;
  for (std::size_t i = 0; i < file->size(); ++i) {
    const auto line = file->line(i);
    if (line.empty()) continue;
    const auto task = text_in(Json::parse(line, nullptr, false), field);
    if (task.empty())
      return Error{Error::Kind::Schema,
                   (folder / name).string(),
                   {static_cast<int>(i) + 1, 1},
                   "expected an object with the field \"" + std::string(field) + "\""};
    lines[task] = line;
  }
  return lines;
}

Result<std::map<std::string, std::vector<Trait>>> traits_of_tasks(const fs::path& file) {
  std::map<std::string, std::vector<Trait>> traits;
  try {
    SqliteFile database(file, SqliteFile::Mode::Read);
    auto rows = database.prepare("SELECT task, dimension || ' ' || value FROM trait ORDER BY rowid");
    while (rows.step()) {
      for (auto& trait : traits_from(rows.text(1))) traits[std::string(rows.text(0))].push_back(std::move(trait));
    }
    return traits;
  } catch (const std::exception& reason) {
    return Error{Error::Kind::Io, file.string(), {}, std::string("cannot read its table trait: ") + reason.what()};
  }
}

std::string mark_of(const Review& review) {
  Json mark{{"format", "unietp-review-mark/1"}, {"task", review.task}, {"verdict", name_of(review.judgement)}};
  if (review.judgement == Judgement::Edit) mark["before"] = review.instruction;
  mark["comment"] = review.comment;
  return mark.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string rejection_of(const TaskLine& task, const Review& review) {
  const Json rejection{{"format", "unietp-rejection/1"},
                       {"slot", task.slot},
                       {"attempt", task.attempt},
                       {"template", task.specification.template_name},
                       {"simulator", name_of(task.specification.simulator)},
                       {"split", name_of(task.specification.split)},
                       {"stage", "review"},
                       {"reason", "rejected"},
                       {"detail", review.comment}};
  return rejection.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// Every file of the folder but paired wordings that are kept as they are, and what nobody here knows.
std::vector<std::string> files_made_anew(const fs::path& folder) {
  std::vector<std::string> names{"tasks.jsonl", "rejections.jsonl", "dataset.sqlite", "README.md", kManifest, kReviews,
                                 kPairs};
  for (const char* part : {"homes", "demonstrations"}) {
    std::error_code code;
    for (const auto& entry : fs::directory_iterator(folder / part, code))
      names.push_back(std::string(part) + "/" + entry.path().filename().string());
  }
  return names;
}

/// Notes in the new manifest how the instructions were written, as the old one has it.
Result<Done> note_writer(const fs::path& file, const Json& old) {
  if (!old.contains("instructions")) return Done{};
  auto manifest = read_json(file);
  if (!manifest) return manifest.error();
  (*manifest)["instructions"] = old.at("instructions");
  return write_file(file, manifest->dump(2) + "\n");
}

}  // namespace

Result<ApplyReport> apply_review(const fs::path& folder, const fs::path& out, const std::vector<Review>& reviews,
                                 const Resources& resources, const ApplyOptions& options) {
  const auto manifest = read_json(folder / kManifest);
  if (!manifest) return manifest.error();
  if (text_in(*manifest, "knowledge_digest") != resources.digest)
    return Error{Error::Kind::Usage,
                 (folder / kManifest).string(),
                 {},
                 "was made with different tables, profiles, layouts or templates; select the right ones "
                 "with --data"};
  const auto configuration =
      configuration_from_json((folder / kManifest).string(), manifest->value("configuration", Json()).dump());
  if (!configuration) return configuration.error();
  const auto tasks = read_task_lines(folder);
  if (!tasks) return tasks.error();
  auto marks = lines_by_task(folder, kReviews, "task");
  if (!marks) return marks.error();
  const auto wordings = lines_by_task(folder, kPairs, "pair");
  if (!wordings) return wordings.error();
  const auto traits = traits_of_tasks(folder / "dataset.sqlite");
  if (!traits) return traits.error();
  std::vector<std::map<std::string, std::string>> demonstrations;  // a mode each
  for (const Mode mode : kModes) {
    auto lines = lines_by_task(folder, demonstrations_file(mode), "task");
    if (!lines) return lines.error();
    demonstrations.push_back(std::move(*lines));
  }

  ApplyReport report;
  const auto rulings = rule_on(reviews, *tasks, {folder, resources, options.accept_unchecked, *marks}, report);
  if (!rulings) return rulings.error();
  auto copy = ChangedCopy::begin(folder, out, files_made_anew(folder));
  if (!copy) return copy.error();
  auto writer = DatasetWriter::begin(copy->folder());
  if (!writer) return writer.error();
  const auto home_of = [&folder](const std::string& layout) { return read_file(folder / home_file(layout)); };
  std::string kept_wordings;
  std::vector<std::string> rejections;
  for (std::size_t i = 0; i < tasks->size(); ++i) {
    const TaskLine& task = (*tasks)[i];
    const Ruling& ruling = (*rulings)[i];
    if (ruling.review != nullptr) (*marks)[task.id] = mark_of(*ruling.review);
    const bool rejected = ruling.review != nullptr && ruling.review->judgement == Judgement::Reject;
    if (rejected && !options.keep_rejected) {
      rejections.push_back(rejection_of(task, *ruling.review));
      continue;
    }
    CandidateRecord record;
    record.task = ruling.rewritten ? reworded_line(task.text, *ruling.rewritten) : task.text;
    for (std::size_t mode = 0; mode < demonstrations.size(); ++mode) {
      const auto line = demonstrations[mode].find(task.id);
      if (line == demonstrations[mode].end()) continue;
      const auto actions =
          actions_of_line((folder / demonstrations_file(kModes[mode])).string() + ", " + task.id, line->second);
      if (!actions) return actions.error();
      const char* gap = record.demonstration.empty() ? "" : "\n";
      record.demonstration += gap + line->second;
      record.actions += gap + *actions;
    }
    if (const auto own = traits->find(task.id); own != traits->end()) record.traits = to_text(own->second);
    if (auto done = writer->add_task(record, home_of); !done) return done.error();
    if (const auto line = wordings->find(task.id); line != wordings->end()) kept_wordings += line->second + "\n";
  }
  const auto old_rejections = read_file(folder / "rejections.jsonl");
  if (!old_rejections) return old_rejections.error();
  auto all_rejections = split(*old_rejections, '\n');
  all_rejections.insert(all_rejections.end(), rejections.begin(), rejections.end());
  for (const auto& line : all_rejections) {
    if (line.empty()) continue;
    if (auto done = writer->add_rejection(line); !done) return done.error();
  }
  std::string kept_marks;
  for (const auto& [task, line] : *marks) kept_marks += line + "\n";
  if (auto done = write_file(copy->folder() / kReviews, kept_marks); !done) return done.error();
  if (!kept_wordings.empty()) {
    if (auto done = write_file(copy->folder() / kPairs, kept_wordings); !done) return done.error();
  }
  if (auto done = writer->finish(*configuration, resources, options.licences); !done) return done.error();
  if (auto done = note_writer(copy->folder() / kManifest, *manifest); !done) return done.error();
  if (auto done = copy->finish(); !done) return done.error();
  return report;
}

}  // namespace unietp
