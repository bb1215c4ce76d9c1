#include <cmath>
#include <exception>

#include "akb/upstream_sizes.h"
#include "bodies.h"
#include "core/files.h"
#include "fuzz_bodies.h"
#include "support.h"

namespace unietp::fuzz {

bool upstream_body(std::string_view text) {
  static const Folder folder("upstream");
  constexpr std::string_view kBetween = "====\n";
  for (const char* room : {"ai2thor", "behavior"}) std::filesystem::create_directories(folder.path() / room);
  for (const char* file : {"ai2thor/procthor_asset_database.json.gz", "ai2thor/ithor_scenes.json.gz",
                           "behavior/object_inventory.json.gz", "behavior/category_mapping.csv.gz"}) {
    const std::size_t end = text.find(kBetween);
    folder.write(file, gzip(text.substr(0, end)));
    text = end == std::string_view::npos ? "" : text.substr(end + kBetween.size());
  }
  try {
    const auto sizes = read_upstream_sizes(folder.path());
    if (!check_result(sizes)) return false;
    for (const auto& [name, size] : *sizes) {
      require(!size.mass || *size.mass > 0);
      require(size.extents.has_value() == !size.extents_source.empty());
    }
    return true;
  } catch (const std::exception& failure) {  // import_simulator makes errors of what nlohmann-json throws
    require(*failure.what() != '\0');
    return false;
  }
}

}  // namespace unietp::fuzz
