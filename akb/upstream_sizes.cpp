#include "akb/upstream_sizes.h"

#include <nlohmann/json.hpp>

#include <algorithm>

#include "akb/import_common.h"
#include "akb/metadata_json.h"

namespace unietp {
namespace {

const std::string kAssetDatabase = "metadata:procthor_asset_database.json.gz",
                  kScenes = "metadata:ithor_scenes.json.gz", kInventory = "metadata:object_inventory.json.gz",
                  kMapping = "metadata:category_mapping.csv.gz";

using Sizes = std::map<std::string, UpstreamSize>;
using Boxes = std::map<std::string, std::vector<Vec3>>;

void add_medians(const Boxes& boxes, const std::string& source, Sizes& sizes) {
  for (const auto& [name, all] : boxes) {
    auto& size = sizes[name];
    if (size.extents) continue;
    size.extents = middle_box(all);
    size.extents_source = source;
  }
}

void add_mass(const std::string& name, double mass, const std::string& source, Sizes& sizes) {
  auto& size = sizes[name];
  if (size.mass || !(mass > 0)) return;
  size.mass = mass;
  size.mass_source = source;
}

Result<Done> add_ai2thor(const std::filesystem::path& upstream, Sizes& sizes) {
  const auto assets = read_procthor_assets(upstream);
  if (!assets) return assets.error();
  const auto scenes = read_metadata_json(upstream / "ai2thor" / "ithor_scenes.json.gz");
  if (!scenes) return scenes.error();
  Boxes boxes;
  for (const auto& asset : *assets) boxes[words_of(asset.category)].push_back(asset.size);
  add_medians(boxes, kAssetDatabase, sizes);
  std::map<std::string, std::vector<double>> masses;
  for (const auto& [id, scene] : scenes->at("scenes").items()) {
    for (const auto& object : scene.at("objects")) {
      if (object.contains("mass"))
        masses[words_of(object.at("objectType").get<std::string>())].push_back(object["mass"]);
    }
  }
  for (const auto& [name, all] : masses) add_mass(name, median(all), kScenes, sizes);
  return Done{};
}

Result<Done> add_behavior(const std::filesystem::path& upstream, Sizes& sizes) {
  const auto inventory = read_metadata_json(upstream / "behavior" / "object_inventory.json.gz");
  if (!inventory) return inventory.error();
  const auto mapping = read_metadata_csv(upstream / "behavior" / "category_mapping.csv.gz");
  if (!mapping) return mapping.error();
  Boxes boxes;
  for (const auto& [model, row] : inventory->at("objects").items()) {
    const auto& size = row.at("size");
    boxes[words_of(model.substr(0, model.rfind('-')))].emplace_back(size.at(1).get<double>(), size.at(0).get<double>(),
                                                                    size.at(2).get<double>());
  }
  add_medians(boxes, kInventory, sizes);
  const auto column = [&](const char* name) {
    const auto at = std::find_if(mapping->header.begin(), mapping->header.end(),
                                 [&](const auto& cell) { return cell.text == name; });
    return static_cast<std::size_t>(at - mapping->header.begin());
  };
  const auto category = column("category"), mass = column("mass (auto)");
  for (const auto& row : mapping->rows) {
    if (std::max(category, mass) >= row.size()) continue;
    auto number = row[mass].text;
    std::erase(number, ',');
    if (!number.empty()) add_mass(words_of(row[category].text), std::stod(number), kMapping, sizes);
  }
  return Done{};
}

}  // namespace

Result<std::vector<Asset>> read_procthor_assets(const std::filesystem::path& upstream) {
  const auto json = read_metadata_json(upstream / "ai2thor" / "procthor_asset_database.json.gz");
  if (!json) return json.error();
  std::vector<Asset> assets;
  for (const auto& [type, list] : json->items()) {
    for (const auto& row : list) {
      const auto& box = row.at("boundingBox");
      const Vec3 size(box.at("x").get<double>(), box.at("z").get<double>(), box.at("y").get<double>());
      assets.push_back({row.at("assetId").get<std::string>(), type, size, {kAssetDatabase, 1}});
    }
  }
  return assets;
}

Result<std::map<std::string, UpstreamSize>> read_upstream_sizes(const std::filesystem::path& upstream) {
  Sizes sizes;
  if (auto read = add_ai2thor(upstream, sizes); !read) return read.error();
  if (auto read = add_behavior(upstream, sizes); !read) return read.error();
  return sizes;
}

}  // namespace unietp
