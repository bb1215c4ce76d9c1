#include "evaluation/dataset_digest.h"

#include <set>

#include "core/digest.h"
#include "core/file_digest.h"
#include "core/files.h"
#include "core/text.h"
#include "record/dataset_lines.h"

namespace unietp {

namespace fs = std::filesystem;

Result<std::string> dataset_digest(const fs::path& folder) {
  std::set<std::string> names{kTasksFile};
  std::error_code failed;
  for (fs::directory_iterator entry(folder / "homes", failed), end; !failed && entry != end; entry.increment(failed))
    names.insert("homes/" + entry->path().filename().string());
  if (failed) return Error{Error::Kind::Io, (folder / "homes").string(), {}, "cannot be read: " + failed.message()};
  std::string all;
  for (const std::string& name : names) {
    const auto digest = digest_of_file(folder, name);
    if (!digest) return digest.error();
    all += name + " " + digest->sha256 + "\n";
  }
  return sha256(all);
}

Result<std::string> benchmark_version(const fs::path& table, const std::string& digest) {
  const auto text = read_file(table);
  if (!text) return text.error();
  int number = 0;
  for (const std::string& line : split(*text, '\n')) {
    ++number;
    if (line.empty() || number == 1) continue;
    const auto fields = split(line, ',');
    if (fields.size() != 2 || fields[1].size() != 64)
      return Error{Error::Kind::Parse, table.string(), {number, 1}, "expected name,digest"};
    if (fields[1] == digest) return fields[0];
  }
  return std::string();
}

}  // namespace unietp
