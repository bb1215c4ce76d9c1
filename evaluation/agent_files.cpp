#include "evaluation/agent_files.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <optional>

#include "core/file_digest.h"
#include "core/in_quotes.h"
#include "core/limits.h"
#include "core/text.h"
#include "evaluation/child_process.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;

Result<Done> add_file(std::map<std::string, std::string>& files, const fs::path& path, const std::string& name) {
  const bool plain = std::none_of(name.begin(), name.end(), [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte < 0x20 || byte > 0x7e;
  });
  if (!plain)
    return Error{Error::Kind::Usage, "--policy", {}, "its file " + in_quotes(name) + " has a name that is not ASCII"};
  const auto digest = digest_of_file(path);
  if (!digest) return digest.error();
  files[name] = digest->sha256;
  return Done{};
}

Result<Done> add_package(std::map<std::string, std::string>& files, const fs::path& base, const std::string& package) {
  std::error_code failed;
  for (fs::recursive_directory_iterator entry(base / package, failed), end; !failed && entry != end;
       entry.increment(failed)) {
    if (entry->path().extension() != ".py" || !entry->is_regular_file(failed)) continue;
    if (files.size() >= limits::kPackageFiles)
      return Error{Error::Kind::Usage,
                   "--policy",
                   {},
                   "the package " + package + " has more than " + std::to_string(limits::kPackageFiles) + " files"};
    const std::string name = entry->path().lexically_relative(base).generic_string();
    if (auto done = add_file(files, entry->path(), name); !done) return done;
  }
  if (failed) return Error{Error::Kind::Io, (base / package).string(), {}, failed.message()};
  return Done{};
}

}  // namespace

Result<std::map<std::string, std::string>> files_of_command(const std::vector<std::string>& words) {
  std::map<std::string, std::string> files;
  if (words.empty()) return files;
  if (const auto program = program_named(words.front())) {
    if (auto done = add_file(files, *program, words.front()); !done) return done.error();
  }
  for (auto word = words.begin() + 1; word != words.end(); ++word) {
    std::error_code failed;
    if (!fs::is_regular_file(*word, failed)) continue;
    if (auto done = add_file(files, *word, *word); !done) return done.error();
  }
  return files;
}

Result<std::map<std::string, std::string>> files_of_python_policy(const std::string& policy) {
  std::map<std::string, std::string> files;
  auto parts = split(policy.substr(policy.find(':') + 1), '.');
  if (parts.size() < 2) return files;
  parts.pop_back();                     // the class
  std::vector<std::string> bases{"."};  // policy_host.py puts the current folder first
  if (const char* more = std::getenv("PYTHONPATH")) {
    for (const std::string& base : split(more, ':')) bases.push_back(base.empty() ? "." : base);
  }
  for (const std::string& base : bases) {
    std::error_code failed;
    // As Python looks for a name: a package, a module, a folder without __init__.py.
    const fs::path package = fs::path(base) / parts.front();
    const std::string module = parts.front() + ".py";
    const bool is_package = fs::is_regular_file(package / "__init__.py", failed);
    if (!is_package && fs::is_regular_file(fs::path(base) / module, failed)) {
      if (auto done = add_file(files, fs::path(base) / module, module); !done) return done.error();
    } else if (fs::is_directory(package, failed)) {
      if (auto done = add_package(files, base, parts.front()); !done) return done.error();
    }
    if (!files.empty()) break;
  }
  return files;
}

}  // namespace unietp
