#include "exports/whole_folder.h"

namespace unietp {

Result<Done> write_whole_folder(const std::filesystem::path& out,
                                const std::function<Result<Done>(const std::filesystem::path& aside)>& write) {
  std::error_code code;
  if (std::filesystem::exists(out, code))
    return Error{Error::Kind::Usage, out.string(), {}, "already exists; expected a new folder"};
  auto aside = out;
  aside += ".partial";
  std::filesystem::remove_all(aside, code);
  std::filesystem::create_directories(aside, code);
  if (code) return Error{Error::Kind::Io, aside.string(), {}, "cannot be created: " + code.message()};
  if (auto written = write(aside); !written) {
    std::filesystem::remove_all(aside, code);
    return written.error();
  }
  std::filesystem::rename(aside, out, code);
  if (code) return Error{Error::Kind::Io, out.string(), {}, "cannot be written: " + code.message()};
  return Done{};
}

}  // namespace unietp
