#include "akb/metadata_json.h"

#include <nlohmann/json.hpp>

#include "bodies.h"
#include "fuzz_bodies.h"
#include "support.h"

namespace unietp::fuzz {

bool metadata_body(std::string_view text) {
  static const Folder folder("metadata");
  folder.write("metadata.json", text);
  const auto json = read_metadata_json(folder.path() / "metadata.json");
  if (!json) {
    check_error(json.error());
    return false;
  }
  folder.write("metadata.json", json->dump());
  const auto again = read_metadata_json(folder.path() / "metadata.json");
  require(again && *again == *json);
  return true;
}

}  // namespace unietp::fuzz
