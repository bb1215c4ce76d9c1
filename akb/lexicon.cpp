#include "akb/lexicon.h"

#include "akb/row_reader.h"
#include "akb/tables.h"
#include "core/files.h"
#include "core/text.h"

namespace unietp {
namespace {

const std::vector<std::string>& lexicon_columns() {
  static const std::vector<std::string> columns{"display", "plural", "synset", "kind",  "archetype", "width",
                                                "depth",   "height", "mass",   "rooms", "colours",   "materials"};
  return columns;
}

std::map<std::string, std::vector<std::string>> read_kinds(const std::filesystem::path& path,
                                                           std::vector<Error>& errors) {
  std::map<std::string, std::vector<std::string>> rooms;
  const auto text = read_file(path);
  if (!text) {
    errors.push_back(text.error());
    return rooms;
  }
  RowReader row(path.string(), *text, {"kind", "rooms"}, errors);
  for (const auto& cells : row.rows()) {
    row.at(cells);
    rooms[row.required("kind")] = row.all_of("rooms", room_types(), "room type");
  }
  return rooms;
}

}  // namespace

std::string regular_plural(std::string_view display) {
  if (const auto of = display.find(" of "); of != std::string_view::npos) {
    return regular_plural(display.substr(0, of)) + std::string(display.substr(of));
  }
  const auto ends = [&](std::string_view suffix) { return display.ends_with(suffix); };
  std::string word(display);
  const bool consonant_y =
      ends("y") && display.size() > 1 && !starts_with_vowel_letter(display.substr(display.size() - 2));
  if (consonant_y) return word.substr(0, word.size() - 1) + "ies";
  if (ends("s") || ends("x") || ends("ch") || ends("sh")) return word + "es";
  return word + "s";
}

Lexicon read_lexicon(const std::filesystem::path& curated, std::vector<Error>& errors) {
  Lexicon lexicon;
  const auto kind_rooms = read_kinds(curated / "kinds.csv", errors);
  const auto path = curated / "lexicon.csv";
  const auto text = read_file(path);
  if (!text) {
    errors.push_back(text.error());
    return lexicon;
  }
  std::vector<std::string> archetypes;
  for (const auto archetype : all_archetypes()) archetypes.emplace_back(name_of(archetype));
  RowReader row(path.string(), *text, lexicon_columns(), errors);
  for (const auto& cells : row.rows()) {
    row.at(cells);
    Word word;
    Category& c = word.category;
    c.display = row.required("display");
    c.countable = row.text("plural") != "-";
    c.plural = !c.countable ? c.display : row.text("plural").empty() ? regular_plural(c.display) : row.text("plural");
    c.synset = row.text("synset");
    c.archetype = archetype_named(row.one_of("archetype", archetypes, "archetype")).value_or(Archetype::Box);
    c.size = {row.number("width", 0, 20, false), row.number("depth", 0, 20, false), row.number("height", 0, 20, false)};
    c.mass = row.number("mass", 0, 2000, false);
    c.rooms = row.all_of("rooms", room_types(), "room type");
    c.colours = row.list("colours");
    c.materials = row.list("materials");
    word.kind = row.required("kind");
    if (const auto usual = kind_rooms.find(word.kind); c.rooms.empty() && usual != kind_rooms.end()) {
      c.rooms = usual->second;
    }
    c.source = c.size_source = c.mass_source = {"curated", 0.8};
    const auto display = c.display;
    if (row.sound() && !lexicon.emplace(display, std::move(word)).second) {
      row.fail("display", "word '" + display + "' twice; expected each once");
    }
  }
  return lexicon;
}

}  // namespace unietp
