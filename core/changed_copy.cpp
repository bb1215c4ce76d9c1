#include "core/changed_copy.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>

namespace unietp {
namespace {

namespace fs = std::filesystem;

Error io(const fs::path& path, const std::string& message) { return {Error::Kind::Io, path.string(), {}, message}; }

fs::path without_slash(const fs::path& path) { return path.has_filename() ? path : path.parent_path(); }

}  // namespace

Result<ChangedCopy> ChangedCopy::begin(const fs::path& source, const fs::path& target,
                                       const std::vector<std::string>& changed) {
  const fs::path from = without_slash(source), to = without_slash(target);
  std::error_code code;
  const bool replaces = fs::equivalent(from, to, code);
  if (!replaces && fs::exists(to, code))
    return Error{
        Error::Kind::Usage, to.string(), {}, "already exists; choose another folder, or remove this one first"};
  const fs::path aside = to.string() + ".changing";
  fs::remove_all(aside, code);  // of a run that was killed
  if (!code) fs::create_directories(aside, code);
  if (code) return io(aside, "cannot create this folder: " + code.message());
  std::vector<fs::path> files;
  for (auto it = fs::recursive_directory_iterator(from, code); !code && it != fs::recursive_directory_iterator();
       it.increment(code)) {
    if (it->is_symlink(code)) return io(it->path(), "is a symbolic link, which is not followed inside a folder");
    if (it->is_regular_file(code)) files.push_back(fs::relative(it->path(), from));
  }
  if (code) return io(from, "cannot list this folder: " + code.message());
  for (const fs::path& file : files) {
    if (std::find(changed.begin(), changed.end(), file.generic_string()) != changed.end()) continue;
    fs::create_directories((aside / file).parent_path(), code);
    fs::create_hard_link(from / file, aside / file, code);
    if (code) fs::copy_file(from / file, aside / file, code);
    if (code) return io(aside / file, "cannot copy this file: " + code.message());
  }
  return ChangedCopy(aside, to, replaces);
}

Result<Done> ChangedCopy::finish() {
  std::error_code code;
  if (!replaces_) {
    fs::rename(folder_, target_, code);
    if (code) return io(target_, "cannot rename the new folder into place: " + code.message());
    return Done{};
  }
  if (::renameat2(AT_FDCWD, folder_.c_str(), AT_FDCWD, target_.c_str(), RENAME_EXCHANGE) != 0) {
    if (errno != EINVAL && errno != ENOSYS)
      return io(target_, std::string("cannot put the new folder in place: ") + std::strerror(errno));
    // A file system that cannot exchange two folders at once: for a moment the name is free.
    const fs::path old = target_.string() + ".old";
    fs::rename(target_, old, code);
    if (!code) fs::rename(folder_, target_, code);
    if (code) return io(target_, "cannot rename the new folder into place: " + code.message());
    fs::remove_all(old, code);
    return Done{};
  }
  fs::remove_all(folder_, code);
  return Done{};
}

}  // namespace unietp
