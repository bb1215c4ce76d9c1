#pragma once

#include <filesystem>
#include <vector>

#include "core/result.h"
#include "resources/resources.h"
#include "run/shard_folder.h"

namespace unietp {

/// All shards of one run, as read from their folders.
struct ShardSet {
  RunConfiguration configuration;
  std::string identity;
  std::vector<std::filesystem::path> folders;
  std::vector<ShardRecord> records;  // of the folders
};

/// Errors: those of read_shard; Usage when two shards are of different runs or numbers of shards, when one is given
/// twice or missing, naming it.
Result<ShardSet> read_shards(const std::vector<std::filesystem::path>& folders);

/// Writes the data set of the run to `out`, all or nothing, with the bytes that one process would have written.
/// `resources`: of the same knowledge. Errors: Usage when `out` exists or the program's version or knowledge are not
/// those of the shards; Io.
Result<Done> merge_shards(const ShardSet& shards, const Resources& resources, const std::filesystem::path& licenses,
                          const std::filesystem::path& out);

}  // namespace unietp
