#include "resources/find_data_folder.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;

bool holds_data(const fs::path& folder) {
  std::error_code code;
  return fs::is_directory(folder / "data" / "akb", code) && fs::is_directory(folder / "templates" / "library", code);
}

}  // namespace

Result<fs::path> find_data_folder(const fs::path& program, const std::string& variable) {
  if (!variable.empty()) {
    if (holds_data(variable)) return fs::path(variable);
    return Error{
        Error::Kind::Usage, "UNIETP_DATA", {}, "\"" + variable + "\" does not hold data/akb and templates/library"};
  }
  const auto installed = program.parent_path().parent_path() / "share" / "unietp";
  if (holds_data(installed)) return installed;
  for (auto folder = program.parent_path(); folder != folder.root_path(); folder = folder.parent_path()) {
    if (holds_data(folder)) return folder;
  }
  return Error{
      Error::Kind::Usage,
      program.string(),
      {},
      "cannot find the program's data (data/akb and templates/library); set UNIETP_DATA or give --data FOLDER"};
}

}  // namespace unietp
