#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "run/assemble.h"
#include "run/shard.h"

namespace unietp {

/// Which part of which run a finished shard is. Read from `shard.json` beside its `ledger.sqlite`.
struct ShardRecord {
  Shard shard;
  std::string identity;                     // of the run (identity_of)
  RunConfiguration configuration;           // that the identity names
  std::vector<std::pair<int, int>> blocks;  // first slot and number of slots of each, in order
};

/// Writes a finished shard to an empty folder: its ledger and `shard.json`. Errors: Io.
Result<Done> write_shard(const std::filesystem::path& folder, const Shard& shard, const std::string& identity,
                         const std::vector<FilledBlock>& blocks);

/// The text of a shard.json. Errors: Parse with line and column; Schema with a JSON pointer.
Result<ShardRecord> shard_from_json(std::string_view where, std::string_view text);

/// Reads the `shard.json` of a folder. Errors: as above; Usage when there is none.
Result<ShardRecord> read_shard(const std::filesystem::path& folder);

/// `<folder>/ledger.sqlite`
std::filesystem::path ledger_of_shard(const std::filesystem::path& folder);

}  // namespace unietp
