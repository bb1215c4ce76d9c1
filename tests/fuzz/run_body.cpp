#include <nlohmann/json.hpp>

#include "bodies.h"
#include "dataset/configuration_json.h"
#include "fuzz_bodies.h"
#include "run/shard_folder.h"
#include "support.h"

namespace unietp::fuzz {

bool configuration_body(std::string_view text) {
  const auto read = configuration_from_json("fuzz", text);
  if (!read) {
    check_error(read.error());
    return false;
  }
  require(read->count >= 1 && read->attempts >= 1 && read->block >= 1);
  require(!read->simulators.empty() && !read->modes.empty() && read->modes.front() == Mode::M1);
  const auto again = configuration_from_json("again", to_json(*read).dump());
  require(again && *again == *read);
  return true;
}

bool shard_body(std::string_view text) {
  const auto read = shard_from_json("fuzz", text);
  if (!read) {
    check_error(read.error());
    return false;
  }
  require(read->shard.number >= 1 && read->shard.number <= read->shard.of);
  for (const auto& [first, slots] : read->blocks) require(first >= 0 && slots >= 0);
  require(nlohmann::ordered_json::parse(read->identity).contains("configuration"));
  return true;
}

}  // namespace unietp::fuzz
