#include "core/staged_folder.h"

#include <fcntl.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <vector>

namespace unietp {
namespace {

namespace fs = std::filesystem;

Error io(const fs::path& path, const std::string& message) { return {Error::Kind::Io, path.string(), {}, message}; }

fs::path replaced_name(const fs::path& target) { return target.string() + ".replaced"; }

/// Where folders cannot change places at once, a process may have been killed when neither had the name, or when the
/// old one was still there.
void put_back(const fs::path& target) {
  std::error_code code;
  if (fs::exists(target, code)) {
    fs::remove_all(replaced_name(target), code);
  } else if (fs::exists(replaced_name(target), code)) {
    fs::rename(replaced_name(target), target, code);
  }
}

/// `aside` gets the name `target`, and the folder that has it now goes.
Result<Done> replace_folder(const fs::path& aside, const fs::path& target) {
  std::error_code code;
  if (::renameat2(AT_FDCWD, aside.c_str(), AT_FDCWD, target.c_str(), RENAME_EXCHANGE) == 0) {
    fs::remove_all(aside, code);
    return Done{};
  }
  if (errno != EINVAL && errno != ENOSYS)
    return io(target, std::string("cannot put the new folder in place: ") + std::strerror(errno));
  const fs::path old = replaced_name(target);
  if (fs::exists(old, code)) return io(old, "is in the way; move it elsewhere, or remove it");
  fs::rename(target, old, code);
  if (!code) fs::rename(aside, target, code);
  if (code) {
    const std::string reason = code.message();
    fs::rename(old, target, code);
    return io(target, "cannot rename the new folder into place: " + reason);
  }
  fs::remove_all(old, code);
  return Done{};
}

Result<Done> take_over(const fs::path& from, const fs::path& to, bool link) {
  std::error_code code;
  fs::create_directories(to.parent_path(), code);
  if (link) fs::create_hard_link(from, to, code);
  if (!link || code) fs::copy_file(from, to, code);
  if (code) return io(to, "cannot copy this file: " + code.message());
  return Done{};
}

}  // namespace

Result<StagedFolder> StagedFolder::begin(const fs::path& asked, bool may_replace) {
  auto lock = FolderLock::take(asked);
  if (!lock) return lock.error();
  const fs::path target = one_name_of(asked), aside = target.string() + ".writing";
  std::error_code code;
  if (!may_replace && fs::exists(target, code))
    return Error{
        Error::Kind::Usage, asked.string(), {}, "already exists; choose another folder, or remove this one first"};
  if (fs::exists(aside, code) && !lock->was_left_over())
    return Error{Error::Kind::Usage, aside.string(), {}, "is in the way; move it elsewhere, or remove it"};
  if (may_replace && lock->was_left_over()) put_back(target);
  fs::remove_all(aside, code);  // of a process that was killed
  if (!code) fs::create_directories(aside, code);
  if (code)
    return io(asked,
              "cannot create " + aside.string() + ": " + code.message() + "; choose a folder that you can write to");
  return StagedFolder(std::move(*lock), target, aside);
}

StagedFolder::~StagedFolder() {
  std::error_code code;
  if (!aside_.empty()) fs::remove_all(aside_, code);
}

Result<Done> StagedFolder::finish() {
  std::error_code code;
  if (fs::exists(target_, code)) {
    if (auto replaced = replace_folder(aside_, target_); !replaced) return replaced;
  } else {
    fs::rename(aside_, target_, code);
    if (code) return io(target_, "cannot rename the new folder into place: " + code.message());
  }
  aside_.clear();
  return Done{};
}

Result<Done> write_staged_folder(const fs::path& source, const fs::path& target,
                                 const std::function<Result<Done>(const fs::path& aside)>& write) {
  auto staged = StagedFolder::begin(target, false);
  if (!staged) return staged.error();
  const auto watch = FolderWatch::begin(source);
  if (!watch) return watch.error();
  if (auto written = write(staged->folder()); !written) return written;
  if (auto same = watch->check_same(); !same) return same;
  return staged->finish();
}

Result<ChangedCopy> ChangedCopy::begin(const fs::path& source, const fs::path& target,
                                       const std::function<bool(const std::string& file)>& is_new) {
  const fs::path from = one_name_of(source);
  const bool replaces = from == one_name_of(target);
  std::error_code code;
  if (!fs::is_directory(from, code) && !(replaces && fs::is_directory(replaced_name(from), code)))
    return Error{Error::Kind::Usage, source.string(), {}, "is not a folder; expected a finished data set"};
  auto staged = StagedFolder::begin(target, replaces);
  if (!staged) return staged.error();
  auto watch = FolderWatch::begin(from);
  if (!watch) return watch.error();
  std::vector<fs::path> files;
  for (auto it = fs::recursive_directory_iterator(from, code); !code && it != fs::recursive_directory_iterator();
       it.increment(code)) {
    if (it->is_symlink(code)) return io(it->path(), "is a symbolic link, which is not followed inside a folder");
    if (it->is_regular_file(code)) files.push_back(fs::relative(it->path(), from));
  }
  if (code) return io(from, "cannot list this folder: " + code.message());
  for (const fs::path& file : files) {
    if (is_new(file.generic_string())) continue;
    if (auto taken = take_over(from / file, staged->folder() / file, replaces); !taken) return taken.error();
  }
  return ChangedCopy(std::move(*watch), std::move(*staged));
}

Result<Done> ChangedCopy::finish() {
  if (auto same = source_.check_same(); !same) return same;
  return staged_.finish();
}

}  // namespace unietp
