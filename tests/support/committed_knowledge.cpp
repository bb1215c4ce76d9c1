#include "tests/support/committed_knowledge.h"

#include <cstdlib>
#include <map>
#include <mutex>
#include <stdexcept>

#include <unistd.h>

namespace unietp {
namespace {

namespace fs = std::filesystem;

/// Files of other builds of this test program, which no process reads any more.
void remove_outdated(const fs::path& folder, const std::string& program, const std::string& current) {
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored)) {
    const auto name = entry.path().filename().string();
    if (name.starts_with(program + "-") && !name.starts_with(current)) fs::remove(entry.path(), ignored);
  }
}

/// In the build folder, or in the one that UNIETP_TEST_CACHE names, for runs that must not share it. The name of the
/// file holds what the compiled tables depend on: the tables and the program with the compiling code.
fs::path compiled_or_reused() {
  const fs::path tables = fs::path(UNIETP_SOURCE_DIR) / "data/akb";
  const auto digest = digest_of_tables(tables, {});
  if (!digest) throw std::runtime_error(format(digest.error()));
  const auto executable = fs::read_symlink("/proc/self/exe");
  const auto program = executable.filename().string();
  const auto built = fs::last_write_time(executable).time_since_epoch().count();
  const auto current = program + "-" + std::to_string(built) + "-" + digest->substr(0, 16);

  const char* other = std::getenv("UNIETP_TEST_CACHE");
  const fs::path folder = other == nullptr ? UNIETP_TEST_CACHE : other;
  const fs::path file = folder / (current + ".sqlite");
  if (fs::exists(file)) return file;
  fs::create_directories(folder);
  remove_outdated(folder, program, current);
  const fs::path aside = folder / (current + "." + std::to_string(::getpid()));
  const auto errors = compile_knowledge(tables, aside);
  if (!errors.empty()) throw std::runtime_error(format(errors.front()));
  fs::rename(aside, file);  // whole or not at all: another process may be compiling too
  return file;
}

}  // namespace

const fs::path& committed_knowledge_file() {
  static const fs::path kFile = compiled_or_reused();
  return kFile;
}

const Knowledge& committed_knowledge(Simulator simulator) {
  static std::mutex mutex;
  static std::map<Simulator, Knowledge> loaded;
  const std::lock_guard lock(mutex);
  if (const auto found = loaded.find(simulator); found != loaded.end()) return found->second;
  auto knowledge = load_knowledge(committed_knowledge_file(), simulator);
  if (!knowledge) throw std::runtime_error(format(knowledge.error()));
  return loaded.emplace(simulator, std::move(*knowledge)).first->second;
}

}  // namespace unietp
