#include "run/shard_folder.h"

#include <nlohmann/json.hpp>

#include "core/files.h"
#include "dataset/configuration_json.h"
#include "record/record_fields.h"
#include "scene/json_parse.h"
#include "scene/json_pointer.h"
#include "scene/json_reader.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::string_view kFormat = "unietp-shard/1";

}  // namespace

fs::path ledger_of_shard(const fs::path& folder) { return folder / "ledger.sqlite"; }

Result<Done> write_shard(const fs::path& folder, const Shard& shard, const std::string& identity,
                         const std::vector<FilledBlock>& blocks) {
  Json own = Json::array();
  for (const FilledBlock& block : blocks) own.push_back({block.first, block.slots});
  const Json json{{"format", kFormat},
                  {"shard", shard.number},
                  {"of", shard.of},
                  {"run", Json::parse(identity)},
                  {"blocks", std::move(own)}};
  if (auto copied = blocks.front().ledger->copy_to(ledger_of_shard(folder)); !copied) return copied.error();
  return write_file(folder, "shard.json", json.dump(2) + "\n");
}

Result<ShardRecord> shard_from_json(std::string_view where, std::string_view text) {
  const auto json = parse_json(where, text);
  if (!json) return json.error();
  JsonReader reader(where);
  const JsonAt root{*json};
  JsonFields fields(reader, root);
  ShardRecord record;
  if (const auto at = fields.required("format"); at && reader.text(*at) != kFormat)
    reader.fail(*at, "expected \"" + std::string(kFormat) + "\"");
  if (const auto at = fields.required("shard")) record.shard.number = read_whole(reader, *at);
  if (const auto at = fields.required("of")) record.shard.of = read_whole(reader, *at);
  const auto run = fields.required("run");
  if (const auto at = fields.required("blocks")) {
    for (std::size_t i = 0; i < reader.items(*at); ++i) {
      const JsonAt block = reader.item(*at, i);
      if (reader.items(block) != 2) {
        reader.fail(block, "expected the first slot and the number of slots");
        break;
      }
      const int first = read_whole(reader, reader.item(block, 0));
      record.blocks.emplace_back(first, read_whole(reader, reader.item(block, 1)));
    }
  }
  fields.finish();
  if (!reader.error() && (record.shard.number < 1 || record.shard.number > record.shard.of))
    reader.fail(root, "expected a shard from 1 to the number of shards");
  if (!reader.error() && !run->json.contains("configuration")) reader.fail(*run, "lacks the configuration");
  if (reader.error()) return *reader.error();
  record.identity = run->json.dump();
  auto configuration =
      configuration_from_json(at_pointer(where, "/run/configuration"), run->json.at("configuration").dump());
  if (!configuration) return configuration.error();
  record.configuration = std::move(*configuration);
  return record;
}

Result<ShardRecord> read_shard(const fs::path& folder) {
  const fs::path file = folder / "shard.json";
  const auto text = read_file(folder, "shard.json");
  if (!text) return Error{Error::Kind::Usage, folder.string(), {}, "is not a finished shard: " + text.error().message};
  return shard_from_json(file.string(), *text);
}

}  // namespace unietp
