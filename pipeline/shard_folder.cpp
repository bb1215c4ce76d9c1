#include "pipeline/shard_folder.h"

#include <nlohmann/json.hpp>

#include "core/files.h"
#include "pipeline/configuration_json.h"
#include "scene/json_parse.h"
#include "scene/json_reader.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::string_view kFormat = "unietp-shard/1";

int whole(JsonReader& reader, const JsonAt& at) { return static_cast<int>(reader.number(at)); }

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
  return write_file(folder / "shard.json", json.dump(2) + "\n");
}

Result<ShardRecord> read_shard(const fs::path& folder) {
  const fs::path file = folder / "shard.json";
  const auto text = read_file(file);
  if (!text) return Error{Error::Kind::Usage, folder.string(), {}, "is no finished shard: " + text.error().message};
  const auto json = parse_json(file.string(), *text);
  if (!json) return json.error();
  JsonReader reader(file.string());
  const JsonAt root{*json};
  JsonFields fields(reader, root);
  ShardRecord record;
  if (const auto at = fields.required("format"); at && reader.text(*at) != kFormat)
    reader.fail(*at, "expected \"" + std::string(kFormat) + "\"");
  if (const auto at = fields.required("shard")) record.shard.number = whole(reader, *at);
  if (const auto at = fields.required("of")) record.shard.of = whole(reader, *at);
  const auto run = fields.required("run");
  if (const auto at = fields.required("blocks")) {
    for (std::size_t i = 0; i < reader.items(*at); ++i) {
      const JsonAt block = reader.item(*at, i);
      if (reader.items(block) != 2) {
        reader.fail(block, "expected the first slot and the number of slots");
        break;
      }
      record.blocks.emplace_back(whole(reader, reader.item(block, 0)), whole(reader, reader.item(block, 1)));
    }
  }
  fields.finish();
  if (!reader.error() && !run->json.contains("configuration")) reader.fail(*run, "lacks the configuration");
  if (reader.error()) return *reader.error();
  record.identity = run->json.dump();
  auto configuration =
      configuration_from_json(file.string() + "#/run/configuration", run->json.at("configuration").dump());
  if (!configuration) return configuration.error();
  record.configuration = std::move(*configuration);
  return record;
}

}  // namespace unietp
