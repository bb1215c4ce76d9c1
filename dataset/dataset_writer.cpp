#include "dataset/dataset_writer.h"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "core/files.h"
#include "core/text.h"
#include "dataset/dataset_card.h"
#include "dataset/manifest.h"
#include "record/home_shelf.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;

Error io_error(const fs::path& path) { return {Error::Kind::Io, path.string(), {}, "cannot write; is the disk full?"}; }

}  // namespace

DatasetWriter::DatasetWriter(fs::path folder, DatasetDatabase database)
    : folder_(std::move(folder)),
      tasks_(folder_ / "tasks.jsonl", std::ios::binary),
      rejections_(folder_ / "rejections.jsonl", std::ios::binary),
      database_(std::move(database)) {}

Result<DatasetWriter> DatasetWriter::begin(const fs::path& folder) {
  std::error_code code;
  fs::create_directories(folder / "homes", code);
  if (!code) fs::create_directories(folder / "demonstrations", code);
  if (code) return Error{Error::Kind::Io, folder.string(), {}, "cannot create this folder: " + code.message()};
  auto database = DatasetDatabase::begin(folder / "dataset.sqlite");
  if (!database) return database.error();
  return DatasetWriter(folder, std::move(*database));
}

Result<Done> DatasetWriter::add_task(const CandidateRecord& record, const HomeSource& homes) {
  // The changes of the start may be longer than all the rest, and nothing here asks for them.
  const auto task = nlohmann::ordered_json::parse(
      record.task, [](int depth, nlohmann::ordered_json::parse_event_t event, const nlohmann::ordered_json& key) {
        return depth != 1 || event != nlohmann::ordered_json::parse_event_t::key || key != "start";
      });
  tasks_ << record.task << '\n';
  if (!tasks_) return io_error(folder_);
  const auto lines = split(record.demonstration, '\n');
  std::vector<nlohmann::ordered_json> demonstrations;
  for (const auto& actions : split(record.actions, '\n')) {
    const auto& line = lines.at(demonstrations.size());
    demonstrations.push_back(nlohmann::ordered_json::parse(actions));
    auto added = add_demonstration(demonstrations.back().at("mode").get<std::string>(), line);
    if (!added) return added;
  }
  if (auto added = add_home(task.at("layout").get<std::string>(), homes); !added) return added;
  ++counts_.tasks;
  ++counts_.by_split[task.at("split").get<std::string>()];
  ++counts_.by_simulator[task.at("simulator").get<std::string>()];
  ++counts_.by_template[task.at("template").get<std::string>()];
  const auto traits = traits_from(record.traits);
  counts_.traits.add(traits);
  return database_.add_task(task, demonstrations, traits);
}

Result<Done> DatasetWriter::add_home(const std::string& layout, const HomeSource& homes) {
  if (!homes_.insert(layout).second) return Done{};
  const auto home = homes(layout);
  if (!home) return home.error();
  return write_file(folder_ / home_file(layout), *home);
}

Result<Done> DatasetWriter::add_demonstration(const std::string& mode, const std::string& line) {
  const auto path = folder_ / "demonstrations" / (mode + ".jsonl");
  const auto [file, is_new] = demonstrations_.try_emplace(mode);
  if (is_new) file->second.open(path, std::ios::binary);
  file->second << line << '\n';
  if (!file->second) return io_error(path);
  return Done{};
}

Result<Done> DatasetWriter::add_rejection(const std::string& line) {
  const auto rejection = nlohmann::ordered_json::parse(line);
  rejections_ << line << '\n';
  if (!rejections_) return io_error(folder_ / "rejections.jsonl");
  ++counts_.rejections[rejection.at("stage").get<std::string>()][rejection.at("reason").get<std::string>()];
  return database_.add_rejection(rejection);
}

Result<Done> DatasetWriter::finish(const RunConfiguration& configuration, const Resources& resources,
                                   const fs::path& licences) {
  if (demonstrations_.empty()) demonstrations_["M1"].open(folder_ / "demonstrations" / "M1.jsonl", std::ios::binary);
  std::vector<std::ofstream*> streams{&tasks_, &rejections_};
  for (auto& [mode, stream] : demonstrations_) streams.push_back(&stream);
  for (auto* stream : streams) {
    stream->close();
    if (!*stream) return io_error(folder_);
  }
  if (auto done = database_.finish(); !done) return done.error();
  const auto sources = sources_of(configuration, resources, licences);
  if (!sources) return sources.error();
  if (auto written = write_file(folder_ / "README.md", dataset_card(configuration, counts_, *sources)); !written)
    return written.error();
  const auto manifest = manifest_of(folder_, configuration, resources, counts_, *sources);
  if (!manifest) return manifest.error();
  return write_file(folder_ / "manifest.json", *manifest);
}

}  // namespace unietp
