#pragma once

#include <filesystem>

#include "akb/knowledge.h"

namespace unietp {

/// The committed tables (data/akb), compiled. ctest starts a process per suite, so the compiled file is kept in the
/// build folder and shared by all processes of one build of a test program. Read only. Throws when the tables are bad.
const std::filesystem::path& committed_knowledge_file();

/// The committed tables of one simulator, loaded once a process. Safe to call from several threads.
const Knowledge& committed_knowledge(Simulator simulator);

}  // namespace unietp
