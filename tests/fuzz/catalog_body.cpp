#include <exception>

#include <nlohmann/json.hpp>

#include "akb/import_behavior.h"
#include "akb/kind_groups.h"
#include "bodies.h"
#include "core/files.h"
#include "fuzz_bodies.h"
#include "support.h"

namespace unietp::fuzz {
namespace {

/// Our own lists that are read with the files, as small as they may be.
void write_lists(const Folder& folder) {
  folder.write("kinds.csv", "kind,rooms\ncup,kitchen\n");
  std::string groups = "group,kind,source\n";
  for (std::size_t i = 0; i < kKindGroupCount; ++i)
    groups += std::string(name_of(static_cast<KindGroup>(i))) + ",cup,curated\n";
  folder.write("kind_groups.csv", groups);
  folder.write("behavior/inventory.csv", "name,synset,source\nmug,mug.n.04,curated\n");
  folder.write("behavior/rooms.csv", "name,room,source\nkitchen,kitchen,curated\n");
  folder.write("behavior/no_homes.csv", "scene,why\ngrocery,shop\n");
  folder.write("behavior/kinds.csv", "kind,like,rooms\nherb,,kitchen\n");
  folder.write("behavior/words.csv", "name,display,plural,kind,archetype,movable,rooms\nmug,mug,,cup,cylinder,,\n");
  folder.write("behavior/forms.csv", "pattern,display,kind,archetype,colours,materials\nhalf__*,half *,slice,box,,\n");
  folder.write("behavior/contents.csv", "ends,kind,materials\nbeer,cup,\n");
  folder.write("behavior/denied.csv", "affordance,categories,reason\n");
  folder.write("behavior/masses.csv", "name,mass\n");
}

}  // namespace

bool catalog_body(std::string_view text) {
  static const Folder folder("catalog");
  static const bool kWritten = [] {
    std::filesystem::create_directories(folder.path() / "behavior");
    write_lists(folder);
    return true;
  }();
  require(kWritten);
  constexpr std::string_view kBetween = "====\n";
  for (const char* file : {"category_mapping.csv.gz", "output_hierarchy.json.gz", "object_inventory.json.gz",
                           "combined_room_object_list.json.gz", "annotations", "behavior/hypernyms.csv"}) {
    const std::size_t end = text.find(kBetween);
    const std::string_view part = text.substr(0, end);
    folder.write(file, std::string_view(file).ends_with(".gz") ? gzip(part) : std::string(part));
    text = end == std::string_view::npos ? "" : text.substr(end + kBetween.size());
  }
  try {
    const auto said = read_metadata_json(folder.path() / "annotations");
    if (!check_result(said)) return false;
    const auto metadata = behavior::read_behavior(folder.path(), folder.path() / "behavior", *said);
    if (!check_result(metadata)) return false;
    require(metadata->categories.contains("mug"));
    std::vector<Error> errors;
    const behavior::Words words(folder.path(), *metadata, errors);
    for (const Error& error : errors) check_error(error);
    for (const auto& [name, facts] : metadata->categories) require(!words.chain(name).empty());
    return errors.empty();
  } catch (const std::exception& failure) {  // import_simulator makes errors of what nlohmann-json throws
    require(*failure.what() != '\0');
    return false;
  }
}

}  // namespace unietp::fuzz
