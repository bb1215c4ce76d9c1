#include <algorithm>

#include "akb/import_behavior.h"
#include "akb/kind_groups.h"
#include "akb/row_reader.h"
#include "akb/table_words.h"
#include "core/files.h"
#include "core/text.h"

namespace unietp::behavior {
namespace {

constexpr double kHeaviestPick_kg = 15, kLargestPick_m = 1.0;
constexpr double kLongestPick_m = 1.4, kLongThing_m = 0.45;  // a broom

bool is_furniture(Archetype archetype) { return archetype <= Archetype::Fixture; }

/// Not fixed in BEHAVIOR's scenes, and one person lifts it (rule `not-scene-object`).
bool can_be_carried(const Facts& facts, const Vec3& size) {
  Vec3 s = size;
  std::sort(s.data(), s.data() + 3);
  const bool handy = s.z() <= kLargestPick_m || (s.z() <= kLongestPick_m && s.y() <= kLongThing_m);
  return !facts.properties.contains("sceneObject") && facts.mass <= kHeaviestPick_kg && handy;
}

std::string spaced(std::string_view name) { return replace_all(std::string(name), "_", " "); }

std::string singular(const std::string& word) {
  return word.ends_with("s") && !word.ends_with("ss") ? word.substr(0, word.size() - 1) : word;
}

}  // namespace

std::vector<Words::Row> Words::read_rows(const std::filesystem::path& path, const std::vector<std::string>& columns,
                                         std::vector<Error>& errors) {
  std::vector<Row> rows;
  const auto text = read_file(path);
  if (!text) {
    errors.push_back(text.error());
    return rows;
  }
  std::vector<std::string> archetypes{""};
  for (const auto archetype : all_archetypes()) archetypes.emplace_back(name_of(archetype));
  RowReader reader(path.string(), *text, columns, errors);
  for (const auto& cells : reader.rows()) {
    reader.at(cells);
    Row row{reader.required(columns.front()), {}};
    for (const auto& column : columns) row.cells[column] = reader.text(column);
    if (row.cells.contains("archetype")) reader.one_of("archetype", archetypes, "archetype");
    if (row.cells.contains("rooms") && row.cells["rooms"] != "-") reader.all_of("rooms", room_types(), "room type");
    if (reader.sound()) rows.push_back(std::move(row));
  }
  return rows;
}

Words::Words(const std::filesystem::path& curated, const Metadata& metadata, std::vector<Error>& errors)
    : metadata_(metadata), kind_rooms_(read_kind_rooms(curated / "kinds.csv", errors)) {
  food_ = read_kind_groups(curated / "kind_groups.csv", errors)[KindGroup::Food];
  const auto folder = curated / "behavior";
  for (const auto& row : read_rows(folder / "kinds.csv", {"kind", "like", "rooms"}, errors)) {
    if (!row.cells.at("like").empty()) like_[row.key] = row.cells.at("like");
    kind_rooms_[row.key] = split(row.cells.at("rooms"), '|');
  }
  const auto keyed = [&](const char* file, const std::vector<std::string>& columns, const auto& known,
                         std::map<std::string, Row>& rows) {
    for (auto& row : read_rows(folder / file, columns, errors)) {
      if (!known(row.key)) {
        errors.push_back({Error::Kind::Schema, (folder / file).string(), {}, "no '" + row.key + "' in the metadata"});
      }
      rows.emplace(row.key, std::move(row));
    }
  };
  std::set<std::string> synsets;
  for (const auto& [below, above] : metadata_.hypernym) synsets.insert({below, above});
  keyed(
      "hypernyms.csv", {"synset", "kind", "archetype", "movable", "rooms", "colours", "materials"},
      [&](const std::string& key) { return synsets.contains(key); }, hypernyms_);
  keyed(
      "words.csv", {"name", "display", "plural", "kind", "archetype", "movable", "rooms"},
      [&](const std::string& key) { return metadata_.categories.contains(key); }, names_);
  forms_ = read_rows(folder / "forms.csv", {"pattern", "display", "kind", "archetype", "colours", "materials"}, errors);
  contents_ = read_rows(folder / "contents.csv", {"ends", "kind", "materials"}, errors);
}

std::vector<std::string> Words::chain(const std::string& name) const {
  std::vector<std::string> chain{metadata_.categories.at(name).synset};
  for (auto at = metadata_.hypernym.find(chain.back());
       at != metadata_.hypernym.end() && chain.size() <= metadata_.hypernym.size();  // more: a file's tree has a circle
       at = metadata_.hypernym.find(chain.back())) {
    chain.push_back(at->second);
  }
  return chain;
}

/// The row of forms.csv that the synset's lemma has the form of, and what stands for its star.
const Words::Row* Words::form(const std::string& name, std::string* content) const {
  const auto& synset = metadata_.categories.at(name).synset;
  const std::string lemma = synset.substr(0, synset.find('.'));
  for (const auto& row : forms_) {
    const auto star = row.key.find('*');
    const std::string head = row.key.substr(0, star), tail = row.key.substr(star + 1);
    if (lemma.size() <= head.size() + tail.size() || !lemma.starts_with(head) || !lemma.ends_with(tail)) continue;
    if (content != nullptr) {
      *content = spaced(lemma.substr(head.size(), lemma.size() - head.size() - tail.size()));
    }
    return &row;
  }
  return nullptr;
}

/// The row of contents.csv with the longest ending of what stands for the star; nullptr if none fits.
const Words::Row* Words::row_of_content(const std::string& content) const {
  const auto fits = [&](const std::string& ending) {
    return (" " + content).ends_with(" " + ending) || (" " + singular(content)).ends_with(" " + ending);
  };
  const Row* best = nullptr;
  for (const auto& row : contents_) {
    if (fits(row.key) && (best == nullptr || row.key.size() > best->key.size())) best = &row;
  }
  return best;
}

/// The cell of the name, else of its form, else of the nearest hypernym that has one.
std::string Words::cell(const std::string& name, const std::string& column) const {
  const auto text_of = [&](const Row& row) {
    const auto found = row.cells.find(column);
    return found == row.cells.end() ? std::string() : found->second;
  };
  if (const auto own = names_.find(name); own != names_.end() && !text_of(own->second).empty()) {
    return text_of(own->second);
  }
  std::string content;
  if (const auto* of_form = form(name, &content); of_form != nullptr && !text_of(*of_form).empty()) {
    auto text = text_of(*of_form);
    // What is sold in plastic only is not in glass; its carton is of paper all the same.
    const bool by_content =
        column == "kind" ? text.starts_with("content") : column == "materials" && text.starts_with("glass");
    const auto* of_content = by_content ? row_of_content(content) : nullptr;
    if (of_content != nullptr && !text_of(*of_content).empty()) return text_of(*of_content);
    const auto other = column == "kind" && by_content ? text.find(':') : std::string::npos;
    if (other != std::string::npos) return text.substr(other + 1);
    if (column != "kind" || !by_content) return text;
  }
  for (const auto& synset : chain(name)) {
    const auto row = hypernyms_.find(synset);
    if (row != hypernyms_.end() && !text_of(row->second).empty()) return text_of(row->second);
  }
  return {};
}

std::string Words::display(const std::string& name) const {
  if (const auto own = names_.find(name); own != names_.end() && !own->second.cells.at("display").empty()) {
    return own->second.cells.at("display");
  }
  std::string content;
  const auto* of_form = form(name, &content);
  if (of_form == nullptr || of_form->cells.at("display").empty()) return spaced(name);
  // Half of what its whole is called here: half_doughnut is of donut, by the synset.
  const auto& pattern = of_form->cells.at("display");
  for (const char* prefix : {"half_", "sliced_"}) {
    if (!name.starts_with(prefix)) continue;
    const auto whole = name.substr(std::string_view(prefix).size());
    const auto known = names_.find(whole);
    const bool uncountable = known != names_.end() && known->second.cells.at("plural") == "-";
    if (uncountable && name.starts_with("half_")) return "piece of " + display(whole);
    return replace_all(pattern, "*", metadata_.categories.contains(whole) ? display(whole) : spaced(whole));
  }
  return replace_all(pattern, "*", content);
}

Word Words::word(const std::string& name) const {
  const Facts& facts = metadata_.categories.at(name);
  Word word;
  Category& c = word.category;
  c.display = display(name);
  const auto own = names_.find(name);
  const auto plural = own == names_.end() ? std::string() : own->second.cells.at("plural");
  c.countable = plural != "-";
  c.plural = !c.countable ? c.display : plural.empty() ? regular_plural(c.display) : plural;
  word.kind = cell(name, "kind");
  if (word.kind == "slice") {  // half a rope is no food
    std::set<std::string> above;
    for (const auto& synset : chain(name)) {
      const auto row = hypernyms_.find(synset);
      if (row != hypernyms_.end()) above.insert(row->second.cells.at("kind"));
    }
    const bool eaten = std::any_of(above.begin(), above.end(), [&](const auto& kind) { return food_.contains(kind); });
    if (!eaten) word.kind = "store";
  }
  auto wanted = archetype_named(cell(name, "archetype")).value_or(Archetype::Box);
  if (wanted == Archetype::Lidded && !opens(facts)) {  // its lid is loose, or on a hinge that does not turn
    wanted = facts.links.contains("joint") ? Archetype::Box : Archetype::Vessel;
  }
  const Body body = body_of(facts, wanted);
  c.archetype = body.archetype;
  c.size = body.size;
  c.size_source = body.source;
  const auto movable = cell(name, "movable");
  c.movable = movable.empty() ? can_be_carried(facts, c.size) : movable == "true";
  const auto whole = metadata_.categories.find(name.starts_with("half_") ? name.substr(5) : "");
  if (whole != metadata_.categories.end() && (facts.mass >= whole->second.mass || whole->second.weighed)) {
    c.mass = std::max(0.001, std::round(whole->second.mass * 500) / 1000);
    c.mass_source = {"derived:half", 0.8};
  } else if (facts.mass > 0) {
    c.mass = std::max(0.001, facts.mass);
    c.mass_source = facts.weighed ? Source{"curated", 0.8} : Source{kTable, 0.9};
  } else {  // about as heavy as water
    c.mass = std::max(0.001, std::round(c.size.prod() * 1e6) / 1e3);
    c.mass_source = {"derived:density", 0.5};
  }
  // What is neither carried nor of the home's furniture is there for scenes that have it: a solid without a room.
  const bool outside = word.kind == "structure" || word.kind == "outdoor" || word.kind == "vehicle";
  if (!c.movable && !is_furniture(c.archetype) && c.archetype != Archetype::Vessel &&
      c.archetype != Archetype::Lidded) {
    c.archetype = Archetype::Fixture;
  }
  const auto rooms = cell(name, "rooms");
  const auto usual = kind_rooms_.find(word.kind);
  if (rooms != "-" && !(outside && !c.movable)) {
    const bool named = own != names_.end() && !own->second.cells.at("rooms").empty();
    c.rooms = !facts.rooms.empty() && !named            ? facts.rooms
              : !rooms.empty()                          ? split(rooms, '|')
              : usual != kind_rooms_.end() && c.movable ? usual->second
                                                        : std::vector<std::string>{};
  }
  const auto list = [](const std::string& text) {
    return text.empty() ? std::vector<std::string>{} : split(text, '|');
  };
  c.colors = list(cell(name, "colours"));
  c.materials = list(cell(name, "materials"));
  return word;
}

}  // namespace unietp::behavior
