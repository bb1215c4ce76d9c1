#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "akb/knowledge.h"
#include "core/result.h"
#include "grounding/home_census.h"

namespace unietp {

/// Real homes of one simulator, from files whose license allows their facts to be shipped.
struct UpstreamHomes {
  std::string source;             // "metadata:ithor_scenes.json.gz"
  std::vector<HomeCensus> homes;  // objects of known categories in rooms of our seven types
  std::string room_source;
  std::vector<HomeCensus> whole;  // homes with all their rooms, for how many of each type there are; objects left out
};

/// AI2-THOR: iTHOR's 120 rooms (each a home of one room) and the freely licensed ProcTHOR houses for room types;
/// VirtualHome: six apartments; BEHAVIOR: the inventories of the 18 homes, gardens' twins left out; Habitat: none.
/// Room types of other names are mapped (a child's room is a bedroom, a private office an office) or left out (a
/// garden, a closet) by room_names.csv of `curated` (data/layouts/curated). Errors: Io; Parse; Schema when a file has
/// another form than expected.
Result<UpstreamHomes> upstream_homes(const std::filesystem::path& upstream, const std::filesystem::path& curated,
                                     const Knowledge& knowledge);

}  // namespace unietp
