#include "resources/frozen_benchmarks.h"

#include "core/digest.h"
#include "core/file_digest.h"
#include "core/files.h"
#include "core/text.h"

namespace unietp {

namespace fs = std::filesystem;

namespace {

constexpr const char* kTasks = "tasks.jsonl";
constexpr const char* kHomes = "homes/";

}  // namespace

std::string dataset_digest(const std::map<std::string, std::string>& files) {
  std::string all;
  for (const auto& [path, digest] : files) {
    if (path == kTasks || path.starts_with(kHomes)) all += path + " " + digest + "\n";
  }
  return sha256(all);
}

Result<std::string> dataset_digest(const fs::path& folder) {
  std::map<std::string, std::string> files{{kTasks, ""}};
  std::error_code failed;
  for (fs::directory_iterator entry(folder / kHomes, failed), end; !failed && entry != end; entry.increment(failed))
    files.emplace(kHomes + entry->path().filename().string(), "");
  if (failed) return Error{Error::Kind::Io, (folder / "homes").string(), {}, "cannot be read: " + failed.message()};
  for (auto& [path, sha] : files) {
    auto digest = digest_of_file(folder, path);
    if (!digest) return digest.error();
    sha = std::move(digest->sha256);
  }
  return dataset_digest(files);
}

Result<FrozenBenchmarks> FrozenBenchmarks::read(const fs::path& table) {
  const auto text = read_file(table);
  if (!text) return text.error();
  FrozenBenchmarks benchmarks;
  int number = 0;
  for (const std::string& line : split(*text, '\n')) {
    ++number;
    if (line.empty() || number == 1) continue;
    const auto fields = split(line, ',');
    if (fields.size() != 2 || fields[1].size() != 64)
      return Error{Error::Kind::Parse, table.string(), {number, 1}, "expected name,digest"};
    benchmarks.names_.emplace(fields[1], fields[0]);
  }
  return benchmarks;
}

std::string FrozenBenchmarks::name_of(const std::string& digest) const {
  const auto found = names_.find(digest);
  return found == names_.end() ? "" : found->second;
}

}  // namespace unietp
