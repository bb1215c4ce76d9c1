#include "shapes/library.h"

#include <algorithm>
#include <array>

#include "akb/csv.h"
#include "core/files.h"
#include "core/in_quotes.h"
#include "core/limits.h"
#include "core/text.h"

namespace unietp {

std::string words_of_category(std::string_view category) {
  std::string words;
  const auto capital = [](char c) { return c >= 'A' && c <= 'Z'; };
  for (std::size_t i = 0; i < category.size(); ++i) {
    const bool ends = i + 1 == category.size() || !capital(category[i + 1]);
    const bool starts = capital(category[i]) && i > 0 && (!capital(category[i - 1]) || !ends);
    if (starts && !words.empty() && words.back() != ' ') words += ' ';
    words += category[i] == '_' || category[i] == '-' ? ' ' : category[i];
  }
  return lower(words);
}

const ShapeFamily* ShapeLibrary::find(std::string_view name) const {
  const auto found =
      std::find_if(families_.begin(), families_.end(), [&](const auto& one) { return one.name == name; });
  return found == families_.end() ? nullptr : &*found;
}

const ShapeFamily* ShapeLibrary::family_of(Simulator simulator, std::string_view category, Archetype archetype) const {
  const auto at = [&](std::size_t i) { return i == kArchetype ? nullptr : &families_[i]; };
  std::string key(name_of(simulator));
  key += ' ';
  key += category;
  if (const auto found = exact_.find(key); found != exact_.end()) return at(found->second);
  const std::string words = words_of_category(category);
  if (const auto found = ends_.find(words); found != ends_.end()) return at(found->second);
  for (std::size_t end = words.size(); end != std::string::npos && end > 0; end = words.rfind(' ', end - 1)) {
    if (const auto found = begins_.find(words.substr(0, end)); found != begins_.end()) return at(found->second);
  }
  for (std::size_t begin = 0;;) {
    if (const auto found = ends_.find(words.substr(begin)); found != ends_.end()) return at(found->second);
    begin = words.find(' ', begin) + 1;  // 0 after the last word
    if (begin == 0) break;
  }
  const auto found = archetypes_.find(std::string(unietp::name_of(archetype)));
  return found == archetypes_.end() ? nullptr : at(found->second);
}

ShapeLibraryReading read_shape_library(const std::vector<ShapeLibrary::File>& files,
                                       const ShapeLibrary::File& categories) {
  ShapeLibraryReading reading;
  ShapeLibrary& library = reading.library;
  std::unordered_map<std::string, std::size_t> known{{"archetype", ShapeLibrary::kArchetype}};
  for (const auto& file : files) {
    auto families = parse_families(file.name, file.text);
    reading.errors.insert(reading.errors.end(), families.errors.begin(), families.errors.end());
    for (ShapeFamily& family : families.families) {
      if (!known.emplace(family.name, library.families_.size()).second)
        reading.errors.push_back(
            {Error::Kind::Schema, file.name, family.pos, "the family " + in_quotes(family.name) + " exists already"});
      library.families_.push_back(std::move(family));
    }
  }
  const CsvFile table = read_csv(categories.name, categories.text);
  reading.errors.insert(reading.errors.end(), table.errors.begin(), table.errors.end());
  const auto fail = [&](const SourcePos& pos, std::string message) {
    reading.errors.push_back({Error::Kind::Schema, categories.name, pos, std::move(message)});
  };
  constexpr std::array<std::string_view, 3> kColumns{"match", "name", "family"};
  const bool sound = table.header.size() == kColumns.size() &&
                     std::equal(kColumns.begin(), kColumns.end(), table.header.begin(),
                                [](std::string_view name, const CsvCell& cell) { return cell.text == name; });
  if (!sound && table.errors.empty()) fail({1, 1}, "expected the columns match, name, family");
  for (const CsvRow& row : table.rows) {
    if (!sound) break;
    const std::string& match = row[0].text;
    const auto family = known.find(row[2].text);
    if (family == known.end()) fail(row[2].pos, "there is no family " + in_quotes(row[2].text));
    const std::size_t place = family == known.end() ? ShapeLibrary::kArchetype : family->second;
    bool fresh = true;
    if (match == "begins") {
      fresh = library.begins_.emplace(row[1].text, place).second;
    } else if (match == "ends") {
      fresh = library.ends_.emplace(row[1].text, place).second;
    } else if (match == "archetype" && archetype_named(row[1].text)) {
      fresh = library.archetypes_.emplace(row[1].text, place).second;
    } else if (simulator_named(match)) {
      fresh = library.exact_.emplace(match + " " + row[1].text, place).second;
    } else {
      fail(row[0].pos, "expected \"begins\", \"ends\", \"archetype\" (with the name of one) or a simulator");
    }
    if (!fresh) fail(row[1].pos, in_quotes(row[1].text) + " has a row already");
  }
  return reading;
}

ShapeLibraryReading load_shape_library(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> paths;
  std::error_code code;
  for (const auto& entry : std::filesystem::directory_iterator(folder, code)) {
    if (entry.path().extension() == ".shapes") paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  std::vector<ShapeLibrary::File> files;
  std::vector<Error> errors;
  const auto read = [&](const std::filesystem::path& path) {
    const auto text = read_file(path);
    if (!text) errors.push_back(text.error());
    return ShapeLibrary::File{path.string(), text ? *text : ""};
  };
  for (const auto& path : paths) files.push_back(read(path));
  const auto categories = read(folder / "categories.csv");
  if (!errors.empty()) return {{}, std::move(errors)};
  return read_shape_library(files, categories);
}

}  // namespace unietp
