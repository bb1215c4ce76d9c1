#include "dataset/dataset_writer.h"

#include "core/files.h"
#include "core/text.h"
#include "core/version.h"
#include "dataset/dataset_card.h"

namespace unietp {

namespace fs = std::filesystem;

std::string home_entry(const std::string& layout) { return "homes/" + layout + ".scene.json.gz"; }

Result<DatasetWriter> DatasetWriter::begin(const fs::path& folder) {
  std::error_code code;
  fs::create_directories(folder / "homes", code);
  if (!code) fs::create_directories(folder / "demonstrations", code);
  if (code) return Error{Error::Kind::Io, folder.string(), {}, "cannot create this folder: " + code.message()};
  auto tasks = LinesWriter::begin(folder / "tasks.jsonl");
  if (!tasks) return tasks.error();
  auto rejections = LinesWriter::begin(folder / "rejections.jsonl");
  if (!rejections) return rejections.error();
  auto database = DatasetDatabase::begin(folder / "dataset.sqlite");
  if (!database) return database.error();
  DatasetWriter writer(folder, std::move(*tasks), std::move(*rejections), std::move(*database));
  return writer;
}

Result<Done> DatasetWriter::add_task(const WrittenTask& task, const std::vector<Trait>& traits,
                                     const HomeSource& homes) {
  const TaskRow& row = task.row;
  const auto modes = modes_of(row);
  if (modes.size() != task.shown.size())
    return Error{Error::Kind::Schema, row.id, {}, "has other demonstrations than its actions are of"};
  if (auto added = tasks_.add(task.line); !added) return added;
  for (std::size_t i = 0; i < modes.size(); ++i) {
    if (auto added = add_demonstration(modes[i], task.shown[i]); !added) return added;
  }
  if (auto added = add_home(row.layout, homes); !added) return added;
  ++counts_.tasks;
  ++counts_.by_split[row.split];
  ++counts_.by_simulator[row.simulator];
  ++counts_.by_template[row.template_name];
  ++counts_.by_sense[row.sense];
  for (const std::string& form : split(row.forms, ' ')) {
    if (!form.empty()) ++counts_.by_form[form];
  }
  if (row.sense != name_of(Grade::Usual)) ++counts_.not_usual[row.template_name];
  traits_.add(traits);
  return database_.add_task(row, traits);
}

Result<Done> DatasetWriter::add_home(const std::string& layout, const HomeSource& homes) {
  if (!homes_.insert(layout).second) return Done{};
  const auto home = homes(layout);
  if (!home) return home.error();
  return write_file(folder_, home_entry(layout), *home);
}

Result<Done> DatasetWriter::add_demonstration(Mode mode, const std::string& line) {
  auto file = demonstrations_.find(mode);
  if (file == demonstrations_.end()) {
    auto begun = LinesWriter::begin(folder_ / "demonstrations" / (std::string(name_of(mode)) + ".jsonl"));
    if (!begun) return begun.error();
    file = demonstrations_.emplace(mode, std::move(*begun)).first;
  }
  return file->second.add(line);
}

Result<Done> DatasetWriter::add_rejection(const RejectionEntry& rejection) {
  if (auto added = rejections_.add(line_of(rejection)); !added) return added;
  ++counts_.rejections[rejection.stage][rejection.reason];
  return database_.add_rejection(rejection);
}

Result<Done> DatasetWriter::finish(const RunConfiguration& configuration, const Resources& resources,
                                   const fs::path& licenses, std::optional<WritingEntry> writing,
                                   std::optional<ReviewCounts> reviews) {
  if (demonstrations_.empty()) {  // of no task
    auto begun = LinesWriter::begin(folder_ / "demonstrations" / "M1.jsonl");
    if (!begun) return begun.error();
    demonstrations_.emplace(Mode::M1, std::move(*begun));
  }
  std::vector<LinesWriter*> files{&tasks_, &rejections_};
  for (auto& [mode, file] : demonstrations_) files.push_back(&file);
  for (auto* file : files) {
    if (auto done = file->finish(); !done) return done;
  }
  if (auto done = database_.finish(); !done) return done.error();
  counts_.balance = traits_.spreads();
  auto sources = sources_of(configuration, resources, licenses);
  if (!sources) return sources.error();
  Manifest manifest{std::string(program_version()),
                    resources.digest,
                    {},
                    configuration,
                    std::move(counts_),
                    {},
                    std::move(*sources),
                    std::move(writing),
                    reviews};
  if (auto written = write_file(folder_, "README.md", dataset_card(manifest)); !written) return written.error();
  auto files_written = files_below(folder_);
  if (!files_written) return files_written.error();
  manifest.files = std::move(*files_written);
  manifest.benchmark = benchmark_of(manifest.files, resources.frozen);
  return write_file(folder_, "manifest.json", to_text(manifest));
}

}  // namespace unietp
