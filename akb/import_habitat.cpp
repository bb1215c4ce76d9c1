#include <nlohmann/json.hpp>

#include "akb/import_common.h"
#include "akb/importers.h"
#include "akb/metadata_json.h"

namespace unietp {
namespace {

using Json = nlohmann::json;
const std::string kOvmm = "metadata:ovmm_categories.json", kOneEach = "metadata:ovmm_one_object_per_category.csv",
                  kAssets = "metadata:procthor_asset_database.json.gz";

/// Boxes of AI2-THOR assets by id: 27 of OVMM's objects are such assets.
std::map<std::string, Vec3> boxes_by_asset(const Json& assets) {
  std::map<std::string, Vec3> boxes;
  for (const auto& [type, list] : assets.items()) {
    for (const auto& asset : list) {
      const auto& box = asset.at("boundingBox");
      boxes[asset.at("assetId")] = {box.at("x").get<double>(), box.at("z").get<double>(), box.at("y").get<double>()};
    }
  }
  return boxes;
}

}  // namespace

Result<Tables> import_habitat(const std::filesystem::path& upstream, const std::filesystem::path& curated) {
  const auto ovmm = read_metadata_json(upstream / "habitat" / "ovmm_categories.json");
  if (!ovmm) return ovmm.error();
  const auto one_each = read_metadata_csv(upstream / "habitat" / "ovmm_one_object_per_category.csv");
  if (!one_each) return one_each.error();
  const auto assets = read_metadata_json(upstream / "ai2thor" / "procthor_asset_database.json.gz");
  if (!assets) return assets.error();

  const auto boxes = boxes_by_asset(*assets);
  std::map<std::string, Vec3> extents;
  for (const auto& row : one_each->rows) {
    if (const auto box = boxes.find(row[0].text); box != boxes.end()) extents[row[1].text] = box->second;
  }
  const auto& objects = ovmm->at("obj_category_to_obj_category_id");
  const auto& receptacles = ovmm->at("recep_category_to_recep_category_id");

  TableBuilder builder(Simulator::Habitat, curated);
  for (const auto& name : builder.curated_names()) {
    RawCategory raw;
    raw.name = name;
    raw.movable = objects.contains(name);
    const bool known = raw.movable || receptacles.contains(name);
    raw.source = known ? Source{kOvmm, 1} : Source{"curated", 0.9};
    if (const auto box = extents.find(name); box != extents.end()) {
      raw.extents = box->second;
      raw.extents_source = kAssets;
    }
    builder.add(raw);
  }
  for (const auto& name : builder.names()) {
    const auto& c = *builder.find(name);
    if (c.movable) builder.afford(name, "pickupable", objects.contains(name) ? kOvmm : "curated", 1);
    if (receptacles.contains(name) && builder.kind(name) != "toilet") {
      const bool hollow = c.archetype == Archetype::Cabinet || c.archetype == Archetype::Basin ||
                          c.archetype == Archetype::Vessel || c.archetype == Archetype::Lidded;
      builder.afford(name, hollow ? "container" : "receptacle", kOvmm, 1);
    }
    const bool has_door =
        c.archetype == Archetype::Cabinet || c.archetype == Archetype::Drawers || c.archetype == Archetype::Lidded;
    if (!c.movable && has_door) {
      builder.afford(name, "openable", "derived:archetype", 0.9);
      builder.afford(name, "container", "derived:archetype", 0.9);
    }
  }
  builder.afford_by_archetype();
  builder.place_by_kind(1);
  return builder.finish();
}

}  // namespace unietp
