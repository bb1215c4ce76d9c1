#include "source_files.h"

#include <gtest/gtest.h>

#include "core/files.h"
#include "includes.h"

namespace unietp {

std::vector<std::filesystem::path> source_files(const std::set<std::filesystem::path>& extensions) {
  namespace fs = std::filesystem;
  const fs::path source = UNIETP_SOURCE_DIR;
  const auto graph = read_file(UNIETP_ROOM_GRAPH);
  EXPECT_TRUE(graph) << UNIETP_ROOM_GRAPH;
  std::vector<std::string> folders = graph ? read_room_graph(*graph).rooms : std::vector<std::string>();
  folders.insert(folders.end(), {"tests", "bench", "python"});
  std::vector<fs::path> files;
  for (const auto& folder : folders) {
    if (!fs::exists(source / folder)) continue;  // a part of the house has not all
    for (const auto& entry : fs::recursive_directory_iterator(source / folder))
      if (extensions.contains(entry.path().extension())) files.push_back(entry.path());
  }
  return files;
}

}  // namespace unietp
