#include <nlohmann/json.hpp>

#include <algorithm>

#include "akb/fit.h"
#include "akb/import_common.h"
#include "akb/importers.h"
#include "akb/metadata_json.h"
#include "akb/upstream_sizes.h"
#include "core/text.h"
#include "scene/simulator.h"

namespace unietp {
namespace {

const std::string kOvmm = "metadata:ovmm_categories.json", kOneEach = "metadata:ovmm_one_object_per_category.csv",
                  kLexicon = "metadata:hssd_semantic_lexicon.json",
                  kProcthorAssets = "metadata:procthor_asset_database.json.gz";

/// The lists that decide what kinds of things there are.
struct Lists {
  std::set<std::string> objects, receptacles;  // OVMM's
  std::set<std::string> scenes;                // HSSD's main categories, and its lexicon's but for what is left out
};

/// OVMM has both "stuffed toy" and "stuffed_toy".
std::set<std::string> names_in(const nlohmann::json& list) {
  std::set<std::string> names;
  for (const auto& [name, id] : list.items()) names.insert(replace_all(name, " ", "_"));
  return names;
}

/// `name,why` of left_out.csv: the words of the lexicon that are no kind of household thing, or that are there already.
Result<std::set<std::string>> read_left_out(const std::filesystem::path& path, const std::set<std::string>& lexicon) {
  const auto file = read_metadata_csv(path);
  if (!file) return file.error();
  std::set<std::string> names;
  for (const auto& row : file->rows) {
    const auto& name = row.front().text;
    if (!lexicon.contains(name)) {
      return Error{Error::Kind::Schema, path.string(), row.front().pos,
                   "no class '" + name + "' to leave out; expected one of hssd_semantic_lexicon.json"};
    }
    names.insert(name);
  }
  return names;
}

Result<Lists> read_lists(const std::filesystem::path& upstream, const std::filesystem::path& curated) {
  const auto ovmm = read_metadata_json(upstream / "habitat" / "ovmm_categories.json");
  if (!ovmm) return ovmm.error();
  const auto hssd = read_metadata_json(upstream / "habitat" / "hssd_semantic_lexicon.json");
  if (!hssd) return hssd.error();
  Lists lists{names_in(ovmm->at("obj_category_to_obj_category_id")),
              names_in(ovmm->at("recep_category_to_recep_category_id")),
              {}};
  const auto lexicon = hssd->at("lexicon_classes").get<std::set<std::string>>();
  const auto left_out = read_left_out(curated / "habitat" / "left_out.csv", lexicon);
  if (!left_out) return left_out.error();
  lists.scenes = hssd->at("hssd_main_categories_short_list").get<std::set<std::string>>();
  std::set_difference(lexicon.begin(), lexicon.end(), left_out->begin(), left_out->end(),
                      std::inserter(lists.scenes, lists.scenes.end()));
  return lists;
}

void add_affordances(TableBuilder& builder, const Lists& lists) {
  for (const auto& name : builder.names()) {
    const auto& c = *builder.find(name);
    if (c.movable) builder.afford(name, "pickupable", lists.objects.contains(name) ? kOvmm : "curated", 1);
    if (lists.receptacles.contains(name) && !builder.is_kind(name, KindGroup::NoReceptacle)) {
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
}

}  // namespace

Result<Tables> import_habitat(const std::filesystem::path& upstream, const std::filesystem::path& curated,
                              const AbsurdPlace& absurd) {
  const auto lists = read_lists(upstream, curated);
  if (!lists) return lists.error();
  const auto one_each = read_metadata_csv(upstream / "habitat" / "ovmm_one_object_per_category.csv");
  if (!one_each) return one_each.error();
  const auto procthor = read_procthor_assets(upstream);
  if (!procthor) return procthor.error();
  const auto sizes = read_upstream_sizes(upstream);
  if (!sizes) return sizes.error();

  std::map<std::string, Asset> own;  // by category: 27 of OVMM's objects are ProcTHOR assets
  for (const auto& row : one_each->rows) {
    const auto asset =
        std::find_if(procthor->begin(), procthor->end(), [&](const Asset& a) { return a.name == row[0].text; });
    if (asset != procthor->end()) own[row[1].text] = {asset->name, row[1].text, asset->size, {kOneEach, 0.9}};
  }
  TableBuilder builder(Simulator::Habitat, curated);
  builder.refuse(absurd);
  std::set<std::string> names = lists->scenes;
  names.insert(lists->objects.begin(), lists->objects.end());
  names.insert(lists->receptacles.begin(), lists->receptacles.end());
  for (const auto& name : builder.curated_names()) names.insert(name);
  for (const auto& name : names) {
    RawCategory raw;
    raw.name = name;
    raw.movable = lists->objects.contains(name);
    raw.source = {"curated", 0.9};
    if (lists->scenes.contains(name)) raw.source = {kLexicon, 0.9};
    if (raw.movable || lists->receptacles.contains(name)) raw.source = {kOvmm, 1};
    if (const auto size = sizes->find(words_of(name)); size != sizes->end()) {
      raw.extents = size->second.extents;
      raw.extents_source = size->second.extents_source;
      raw.mass = size->second.mass;
      raw.mass_source = size->second.mass_source;
    }
    if (const auto asset = own.find(name); asset != own.end()) {
      raw.extents = asset->second.size;
      raw.extents_source = kProcthorAssets;
    }
    builder.add(raw);
    // What a hamper holds goes by its size: a lent one would be as small as the models that happen to be there.
    const auto* lent = builder.find(name);
    if (lent != nullptr && !lent->movable && raw.extents && room_of(*lent, Predicate::Inside)) {
      raw.extents.reset();
      builder.add(raw);
    }
  }
  for (const auto& [name, asset] : own) builder.model(asset);
  add_affordances(builder, *lists);
  builder.place_by_kind(1);
  return builder.finish();
}

}  // namespace unietp
