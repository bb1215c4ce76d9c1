#include "real_tables.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <map>
#include <stdexcept>

namespace unietp {
namespace {

namespace fs = std::filesystem;

std::map<Simulator, Knowledge> read_all() {
  const auto folder = fs::temp_directory_path() / ("unietp_generator_" + std::to_string(::getpid()));
  fs::create_directories(folder);
  for (const auto& error : compile_knowledge(fs::path(UNIETP_SOURCE_DIR) / "data/akb", folder / "knowledge.sqlite")) {
    ADD_FAILURE() << format(error);
  }
  std::map<Simulator, Knowledge> read;
  for (const auto simulator : kSimulators) {
    auto loaded = load_knowledge(folder / "knowledge.sqlite", simulator);
    if (!loaded) throw std::runtime_error(format(loaded.error()));
    read.emplace(simulator, std::move(*loaded));
  }
  fs::remove_all(folder);
  return read;
}

}  // namespace

const Knowledge& real_tables(Simulator simulator) {
  static const auto kRead = read_all();
  return kRead.at(simulator);
}

}  // namespace unietp
