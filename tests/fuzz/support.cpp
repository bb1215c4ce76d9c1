#include "support.h"

#include <unistd.h>

#include <fstream>

#include "fuzz_bodies.h"

namespace unietp::fuzz {

Folder::Folder(std::string_view name)
    : path_(std::filesystem::temp_directory_path() /
            ("unietp_fuzz_" + std::string(name) + "_" + std::to_string(getpid()))) {
  std::filesystem::create_directories(path_);
}
Folder::~Folder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}
void Folder::write(std::string_view name, std::string_view bytes) const {
  std::ofstream out(path_ / name, std::ios::binary);
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  require(static_cast<bool>(out.flush()));
}

void check_error(const Error& error) {
  require(!error.where.empty() && !error.message.empty());
  require(error.pos.line >= 0 && error.pos.column >= 0);
  require(!format(error).empty());
}

void check_formula(const Formula& formula, FormulaUse use) {
  const auto again = parse_formula("fuzz", to_text(formula), use);
  require(static_cast<bool>(again));
  require(*again == formula);
}

}  // namespace unietp::fuzz
