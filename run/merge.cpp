#include "run/merge.h"

#include <algorithm>
#include <memory>
#include <set>

#include <nlohmann/json.hpp>

#include "run/run.h"
#include "run/run_folder.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;

std::string name_of(const Shard& shard) { return std::to_string(shard.number) + "/" + std::to_string(shard.of); }

}  // namespace

Result<ShardSet> read_shards(const std::vector<fs::path>& folders) {
  ShardSet set;
  std::set<int> seen;
  for (const fs::path& folder : folders) {
    auto record = read_shard(folder);
    if (!record) return record.error();
    if (set.records.empty()) {
      set.configuration = record->configuration;
      set.identity = record->identity;
    }
    const Shard& first = set.records.empty() ? record->shard : set.records.front().shard;
    if (record->identity != set.identity)
      return usage_error(folder, "belongs to a different run than " + folders.front().string() +
                                     "\n  that: " + set.identity + "\n  this: " + record->identity);
    if (record->shard.of != first.of)
      return usage_error(
          folder, "is shard " + name_of(record->shard) + ", but " + folders.front().string() + " is " + name_of(first));
    if (!seen.insert(record->shard.number).second)
      return usage_error(folder, "is shard " + name_of(record->shard) + ", which was already given");
    set.folders.push_back(folder);
    set.records.push_back(std::move(*record));
  }
  for (int number = 1; !set.records.empty() && number <= set.records.front().shard.of; ++number) {
    if (!seen.contains(number))
      return usage_error(folders.front(), "shard " + std::to_string(number) + " of " +
                                              std::to_string(set.records.front().shard.of) +
                                              " is missing; give the folders of all shards");
  }
  return set;
}

Result<Done> merge_shards(const ShardSet& shards, const Resources& resources, const fs::path& licenses,
                          const fs::path& out) {
  const auto identity = identity_of(shards.configuration, resources);
  if (identity != shards.identity)
    return usage_error(shards.folders.front(),
                       "was made by a different version or with different knowledge\n  it was:  " + shards.identity +
                           "\n  this is: " + identity);
  std::vector<std::unique_ptr<Ledger>> ledgers;
  std::vector<FilledBlock> blocks;
  for (std::size_t i = 0; i < shards.records.size(); ++i) {
    auto ledger = Ledger::read_only(ledger_of_shard(shards.folders[i]), identity);
    if (!ledger) return ledger.error();
    ledgers.push_back(std::make_unique<Ledger>(std::move(*ledger)));
    for (const auto& [first, slots] : shards.records[i].blocks) blocks.push_back({first, slots, ledgers.back().get()});
  }
  std::sort(blocks.begin(), blocks.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  int covered = 0;  // slots from the first on, each once
  for (const FilledBlock& block : blocks) {
    if (block.first != covered || block.slots < 1 || block.slots > shards.configuration.count - covered) break;
    covered += block.slots;
  }
  if (covered != shards.configuration.count)
    return usage_error(shards.folders.front(),
                       "a shard.json is damaged: the blocks of the shards do not cover the run's " +
                           std::to_string(shards.configuration.count) + " tasks exactly once");
  const auto parts = static_cast<int>(shards.records.size());
  auto work = RunFolder::enter(out, nlohmann::ordered_json{{"merge of shards", parts}, {"run", identity}}.dump(), true);
  if (!work) return work.error();
  if (work->already_published()) return Done{};
  const auto folder = work->fresh_data_folder();
  if (!folder) return folder.error();
  if (auto written = assemble(*folder, shards.configuration, resources, licenses, blocks); !written)
    return written.error();
  return work->publish();
}

}  // namespace unietp
