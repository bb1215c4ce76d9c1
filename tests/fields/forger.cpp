#include "forger.h"

#include <cctype>
#include <map>

#include "core/rng.h"
#include "core/text.h"
#include "json_changes.h"
#include "scene/scene_json.h"
#include "table_changes.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

std::string kind_of(const std::string& file) { return file.starts_with("homes/") ? "homes" : file; }

/// Collects forgeries: of each kind of file, field and way so many.
class Forger {
 public:
  Forger(const ForgedSet& set, int each) : set_(set), each_(each) {}

  std::vector<Forgery> all() {
    for (const auto& file : set_.files()) {
      if (file.ends_with(".jsonl")) {
        forge_lines(file);
      } else if (file.ends_with(".json") || file.ends_with(".gz")) {
        collect_values(Json::parse(set_.text(file)), "", values_[kind_of(file)]);
      }
    }
    for (const auto& file : set_.files()) {
      if (file.ends_with(".json") || file.ends_with(".gz")) forge_document(file);
    }
    forge_card();
    forge_database();
    return std::move(forgeries_);
  }

 private:
  bool wanted(const std::string& file, const std::string& field, const std::string& how) {
    return counts_[file + " " + field + " " + how] < each_;
  }
  void add(Forgery forgery) {
    ++counts_[forgery.file + " " + forgery.field + " " + forgery.how];
    forgeries_.push_back(std::move(forgery));
  }

  /// One change of each field and way, drawn among those of the text.
  std::vector<JsonChange> drawn(const Json& json, const std::string& kind, std::uint64_t number) {
    std::map<std::string, std::vector<JsonChange>> by_key;
    for (auto& change : changes_of_json(json, values_[kind])) {
      if (wanted(kind, change.field, change.how)) by_key[change.field + " " + change.how].push_back(std::move(change));
    }
    std::vector<JsonChange> chosen;
    Rng rng = Rng(1).fork(kind, number);
    for (auto& [key, changes] : by_key) chosen.push_back(std::move(changes[rng.below(changes.size())]));
    return chosen;
  }

  void forge_lines(const std::string& file) {
    auto lines = split(set_.text(file), '\n');
    if (!lines.empty() && lines.back().empty()) lines.pop_back();
    for (const auto& line : lines) collect_values(Json::parse(line), "", values_[file]);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const Json json = Json::parse(lines[i]);
      for (auto& change : drawn(json, file, i)) {
        add({file, change.field, change.how, "line " + std::to_string(i + 1) + " " + change.place.to_string(),
             [file, i, change](ForgedSet& set) {
               auto all = split(set.text(file), '\n');
               auto changed = Json::parse(all[i]);
               change.apply(changed);
               all[i] = changed.dump();
               return set.with(file, join(all, "\n"));
             }});
      }
    }
    const auto forge_file = [&](const char* how, std::size_t at,
                                std::function<void(std::vector<std::string>&)> change) {
      if (lines.size() < 2 || !wanted(file, "", how)) return;
      add({file, "", how, "line " + std::to_string(at + 1), [file, change](ForgedSet& set) {
             auto all = split(set.text(file), '\n');
             change(all);
             return set.with(file, join(all, "\n"));
           }});
    };
    for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
      const auto at = static_cast<std::ptrdiff_t>(i);
      forge_file("line dropped", i, [at](auto& all) { all.erase(all.begin() + at); });
      forge_file("line doubled", i, [at](auto& all) { all.insert(all.begin() + at, std::string(all[at])); });
      forge_file("lines swapped", i, [at](auto& all) { std::swap(all[at], all[at + 1]); });
    }
  }

  void forge_document(const std::string& file) {
    const std::string kind = kind_of(file);
    const bool indented = file == "manifest.json";
    const Json json = Json::parse(set_.text(file));
    const int rounds = indented ? each_ : 1;  // of homes there are many
    for (int round = 0; round < rounds; ++round) {
      for (auto& change : drawn(json, kind, documents_++)) {
        add({kind, change.field, change.how, file + " " + change.place.to_string(),
             [file, change, indented](ForgedSet& set) {
               auto changed = Json::parse(set.text(file));
               change.apply(changed);
               if (indented) return set.with(file, changed.dump(2) + "\n");
               // As the writer would write it, where it still reads.
               const auto scene = scene_from_json(file, changed.dump());
               const std::string text = scene ? scene_to_json(*scene) : changed.dump();
               return set.with(file, text == set.text(file) ? changed.dump() : text);
             }});
      }
    }
  }

  void forge_card() {
    const std::string file = "README.md";
    const auto lines = split(set_.text(file), '\n');
    const auto change = [&](std::size_t i, const char* how, std::string line) {
      if (!wanted(file, "line " + std::to_string(i + 1), how)) return;
      add({file, "line " + std::to_string(i + 1), how, lines[i], [file, i, line = std::move(line)](ForgedSet& set) {
             auto all = split(set.text(file), '\n');
             all[i] = line;
             return set.with(file, join(all, "\n"));
           }});
    };
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const std::string& line = lines[i];
      for (std::size_t at = 0; at < line.size(); ++at) {
        if (std::isdigit(static_cast<unsigned char>(line[at])) == 0) continue;
        std::string other = line;
        other[at] = other[at] == '9' ? '1' : static_cast<char>(other[at] + 1);
        change(i, "a digit", other);
        break;
      }
      if (line.starts_with("|") || line.starts_with("-")) change(i, "a letter more", line + "x");
      if (const auto mark = line.find('`'); mark != std::string::npos)
        change(i, "a name", line.substr(0, mark + 1) + "x" + line.substr(mark + 1));
    }
  }

  void forge_database() {
    for (auto& change : changes_of_database(set_.folder() / "dataset.sqlite", each_)) {
      add({"dataset.sqlite", change.field, change.how, change.sql,
           [sql = change.sql](ForgedSet& set) { return set.with_database(sql); }});
    }
  }

  const ForgedSet& set_;
  int each_;
  std::uint64_t documents_ = 0;
  std::map<std::string, KnownValues> values_;
  std::map<std::string, int> counts_;
  std::vector<Forgery> forgeries_;
};

}  // namespace

std::vector<Forgery> forgeries(const ForgedSet& set, int each) { return Forger(set, each).all(); }

}  // namespace unietp
