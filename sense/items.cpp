#include "sense/items.h"

#include <algorithm>
#include <charconv>
#include <optional>

#include <nlohmann/json.hpp>

#include "akb/metadata_json.h"
#include "core/text.h"

namespace unietp {
namespace {

constexpr std::string_view kVotes = "metadata:preferences.csv.gz", kPlacements = "metadata:procthor_receptacles.json";
constexpr int kBelongs = 6;  // votes of ten

int int_of(const std::string& text) {
  int number = 0;
  std::from_chars(text.data(), text.data() + text.size(), number);
  return number;
}

/// The kind of a receptacle as Housekeep names it, which has one name for the cabinets of all rooms, and one for their
/// shelves: words.csv has rows for a receptacle in a room.
std::optional<std::string> receptacle_kind(const WordKinds& words, const std::string& room, const std::string& name) {
  constexpr std::string_view kList = "housekeep";
  const auto in_room = words.of_word(room + "/" + name, kList);
  return in_room ? in_room : words.of_word(name, kList);
}

}  // namespace

Role usual_place(const Kinds& kinds, const std::string& place) {
  return kinds.place_role(kinds.usual_relation(place), place);
}

Result<std::vector<Item>> vote_items(const std::filesystem::path& file, const Vocabulary& vocabulary) {
  const auto table = read_metadata_csv(file);
  if (!table) return table.error();
  std::vector<Item> items;
  for (const auto& row : table->rows) {  // object, room, receptacle, belongs, misplaced, implausible, ...
    const auto thing = vocabulary.words.of_word(row[0].text, "housekeep");
    const auto place = receptacle_kind(vocabulary.words, row[1].text, row[2].text);
    if (!thing || !place || !vocabulary.kinds.is_a(*place, "place")) continue;
    const int votes = int_of(row[3].text), against = int_of(row[5].text);
    if (votes < kBelongs && against < kBelongs) continue;
    const auto role = usual_place(vocabulary.kinds, *place);
    const double weight = std::max(0.06 * (votes - 5), 0.06);
    items.push_back({{*thing, role, weight, row[0].text + " at " + row[2].text, std::string(kVotes)},
                     row[0].text,
                     votes >= kBelongs});
  }
  return items;
}

Result<std::vector<Item>> placement_items(const std::filesystem::path& file, const Vocabulary& vocabulary) {
  const auto json = read_metadata_json(file);
  if (!json) return json.error();
  std::vector<Item> items;
  for (const auto& [receptacle, objects] : json->items()) {
    const auto place = vocabulary.words.of_word(receptacle);
    if (!place || !objects.is_object()) continue;
    for (const auto& [object, numbers] : objects.items()) {
      const auto thing = vocabulary.words.of_word(object);
      if (!thing || !numbers.contains("count") || !numbers["count"].is_number()) continue;
      const double weight = std::min(3.0, numbers["count"].get<double>() / 4);
      if (weight <= 0) continue;
      items.push_back({{*thing, usual_place(vocabulary.kinds, *place), weight, object + " at " + receptacle,
                        std::string(kPlacements)},
                       object});
    }
  }
  return items;
}

}  // namespace unietp
