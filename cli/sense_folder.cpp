#include "cli/sense_folder.h"

namespace unietp {

std::filesystem::path sense_folder(const CommandLine& program) { return program.folders.root / "data/sense"; }

}  // namespace unietp
