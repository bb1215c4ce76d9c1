#include "cli/output_place.h"

#include "core/files.h"
#include "core/folder_lock.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;

/// Whether the folder has a file of this name with the name of a format of this program in it.
bool has_file(const fs::path& folder, const char* name, std::string_view format) {
  std::error_code code;
  if (!fs::exists(folder / name, code)) return false;
  const auto text = read_file(folder, name);
  return text && text->find(format) != std::string::npos;
}

/// What the folder is, in words; empty when it is nothing of this program's.
std::string kind_of(const fs::path& folder) {
  if (has_file(folder, "manifest.json", "\"unietp-manifest/")) return "data set";
  if (has_file(folder, "manifest.json", "\"unietp-evaluation/")) return "evaluation";
  if (has_file(folder, "shard.json", "\"unietp-shard/")) return "shard";
  std::error_code code;
  const bool runs = fs::exists(folder / "run.json", code) || fs::exists(folder / "publishing", code);
  return runs && folder.extension() == ".partial" ? "unfinished run" : "";
}

}  // namespace

std::string refusal_of_output(const fs::path& path) {
  std::error_code code;
  fs::path part;
  for (const fs::path& name : fs::absolute(path, code)) {
    part /= name;
    if (fs::is_symlink(part, code) && !fs::exists(part, code))
      return part.string() + " is a symbolic link that leads nowhere; remove it, or choose another place";
  }
  fs::path folder = one_name_of(path);
  while (folder.has_relative_path()) {
    folder = folder.parent_path();
    if (const auto kind = kind_of(folder); !kind.empty())
      return path.string() + " is inside the " + kind + " " + folder.string() + "; choose a place outside of it";
  }
  return "";
}

}  // namespace unietp
