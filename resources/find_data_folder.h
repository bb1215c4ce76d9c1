#pragma once

#include <filesystem>
#include <string>

#include "core/result.h"

namespace unietp {

/// The folder that holds the program's data/ and templates/library/, in this order:
///  - `variable`, the value of UNIETP_DATA, when it is not empty;
///  - `share/unietp` beside the folder of the program, as `cmake --install` and packages place it;
///  - the nearest folder above the program that holds both, as in a source checkout.
/// `program`: absolute path of the executable, without symbolic links. Errors: Usage when there is none.
Result<std::filesystem::path> find_data_folder(const std::filesystem::path& program, const std::string& variable);

}  // namespace unietp
