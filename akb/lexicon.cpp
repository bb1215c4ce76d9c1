#include "akb/lexicon.h"

#include <algorithm>

#include "akb/row_reader.h"
#include "akb/table_words.h"
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

void read_words(const std::filesystem::path& path, const std::map<std::string, std::vector<std::string>>& kind_rooms,
                Lexicon& lexicon, std::vector<Error>& errors) {
  const auto text = read_file(path);
  if (!text) {
    errors.push_back(text.error());
    return;
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
    c.colors = row.list("colours");
    c.materials = row.list("materials");
    word.kind = row.required("kind");
    if (const auto usual = kind_rooms.find(word.kind); c.rooms.empty() && usual != kind_rooms.end()) {
      c.rooms = usual->second;
    }
    c.source = c.size_source = c.mass_source = {"curated", 0.8};
    const auto display = c.display;
    if (row.sound() && !lexicon.emplace(display, std::move(word)).second) {
      row.fail("display", "word '" + display + "' is duplicated; expected each once");
    }
  }
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
  static const std::pair<std::string_view, std::string_view> kIrregular[] = {
      {"knife", "knives"},  {"leaf", "leaves"}, {"loaf", "loaves"},     {"shelf", "shelves"},
      {"scarf", "scarves"}, {"half", "halves"}, {"potato", "potatoes"}, {"tomato", "tomatoes"},
      {"mouse", "mice"},    {"foot", "feet"},   {"tooth", "teeth"},     {"mango", "mangoes"}};
  for (const auto& [one, many] : kIrregular) {
    const bool whole_word = display == one || (ends(one) && display[display.size() - one.size() - 1] == ' ');
    if (whole_word) return word.substr(0, word.size() - one.size()) + std::string(many);
  }
  if (ends("s") || ends("x") || ends("ch") || ends("sh")) return word + "es";
  return word + "s";
}

std::map<std::string, std::vector<std::string>> read_kind_rooms(const std::filesystem::path& path,
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

std::vector<std::filesystem::path> parts_of(const std::filesystem::path& folder, std::string_view stem,
                                            std::vector<Error>& errors) {
  std::vector<std::filesystem::path> parts;
  std::error_code unreadable;
  for (const auto& entry : std::filesystem::directory_iterator(folder, unreadable)) {
    const auto name = entry.path().filename().string();
    if (name.starts_with(stem) && name.ends_with(".csv")) parts.push_back(entry.path());
  }
  std::sort(parts.begin(), parts.end());
  if (parts.empty()) {
    const auto wanted = std::string(stem) + "*.csv";
    errors.push_back(
        {Error::Kind::Io, (folder / wanted).string(), {}, "no such file; expected at least one " + wanted});
  }
  return parts;
}

Lexicon read_lexicon(const std::filesystem::path& curated, std::vector<Error>& errors) {
  Lexicon lexicon;
  const auto kind_rooms = read_kind_rooms(curated / "kinds.csv", errors);
  for (const auto& path : parts_of(curated, "lexicon", errors)) read_words(path, kind_rooms, lexicon, errors);
  return lexicon;
}

}  // namespace unietp
