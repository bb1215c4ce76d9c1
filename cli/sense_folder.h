#pragma once

#include <filesystem>

#include "cli/commands.h"
#include "sense/common_sense.h"
#include "sense/word_kinds.h"

namespace unietp {

/// Where the tables of what people do with things are.
std::filesystem::path sense_folder(const CommandLine& program);

}  // namespace unietp
