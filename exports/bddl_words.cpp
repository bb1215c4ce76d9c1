#include "exports/bddl_words.h"

#include "akb/csv.h"
#include "core/files.h"

namespace unietp {
namespace {

/// What a state is in BDDL: a predicate, the substance that it is about, and whether it is negated.
struct Word {
  std::string_view name;
  std::string_view substance = {};  // ours
  bool negated = false;
};

/// A dirty object is covered with stains, a soaked one saturated with water. An empty `name`: BDDL has none.
Word word_of(const State& state) {
  switch (state.predicate) {
    case Predicate::Open:
      return {"open"};
    case Predicate::Closed:
      return {"open", "", true};
    case Predicate::PowerOn:
      return {"toggled_on"};
    case Predicate::PowerOff:
      return {"toggled_on", "", true};
    case Predicate::Hot:
      return {"hot"};
    case Predicate::Cooked:
      return {"cooked"};
    case Predicate::Raw:
      return {"cooked", "", true};
    case Predicate::Frozen:
      return {"frozen"};
    case Predicate::Thawed:
      return {"frozen", "", true};
    case Predicate::Folded:
      return {"folded"};
    case Predicate::Unfolded:
      return {"unfolded"};
    case Predicate::Dirty:
      return {"covered", "stain"};
    case Predicate::Clean:
      return {"covered", "stain", true};
    case Predicate::Soaked:
      return {"saturated", "water"};
    case Predicate::Dry:
      return {"saturated", "water", true};
    case Predicate::Filled:
      return {"filled", state.symbol};
    case Predicate::Covered:
      return {"covered", state.symbol};
    default:
      return {};
  }
}

}  // namespace

Result<BddlSynsets> read_bddl_synsets(const std::filesystem::path& file) {
  const auto text = read_file(file);
  if (!text) return text.error();
  const CsvFile table = read_csv(file.string(), *text);
  if (!table.errors.empty()) return table.errors.front();
  const auto& header = table.header;
  if (header.size() < 2 || (header[0].text != "category" && header[0].text != "substance") ||
      header[1].text != "synset")
    return Error{Error::Kind::Schema, file.string(), {1, 1}, "expected the columns category or substance, and synset"};
  BddlSynsets synsets;
  for (const CsvRow& row : table.rows) synsets[row[0].text] = row[1].text;
  return synsets;
}

Result<BddlWords> read_bddl_words(const std::filesystem::path& folder) {
  auto categories = read_bddl_synsets(folder / "synsets.csv");
  if (!categories) return categories.error();
  auto substances = read_bddl_synsets(folder / "substances.csv");
  if (!substances) return substances.error();
  return BddlWords{std::move(*categories), std::move(*substances)};
}

std::set<std::string> liquids_of(const Scene& start, const Knowledge& knowledge) {
  std::set<std::string> liquids;
  for (const Node& node : start.nodes) {
    for (const State& state : node.states.all()) {
      if (state.predicate == Predicate::Filled) liquids.insert(state.symbol);
    }
    for (const Effect* effect : knowledge.effects_on(node.category, Treatment::Fills)) liquids.insert(effect->gives);
  }
  return liquids;
}

std::string bddl_state(const State& state, const std::string& object, const BddlWords& words,
                       const std::set<std::string>& liquids, std::set<std::string>& used) {
  const std::string mark = object.starts_with('?') ? "?" : "";
  if (state.predicate == Predicate::Held) return "(grasped " + mark + kBddlAgent + " " + object + ")";
  const auto with = [&](std::string_view name, std::string_view substance) -> std::string {
    const auto synset = words.substances.find(substance);
    if (synset == words.substances.end()) return "";
    used.insert(synset->second);
    return "(" + std::string(name) + " " + object + " " + mark + synset->second + "_1)";
  };
  const bool is_any = state.predicate == Predicate::Filled && state.symbol == "any";
  if (state.predicate == Predicate::Empty || is_any) {
    std::string each;
    for (const std::string& liquid : liquids) {
      const std::string one = with("contains", liquid);
      if (one.empty()) return "";
      each += is_any ? " " + one : " (not " + one + ")";
    }
    return each.empty() ? "" : (is_any ? "(or" : "(and") + each + ")";
  }
  const Word word = word_of(state);
  if (word.name.empty()) return "";
  const std::string literal =
      word.substance.empty() ? "(" + std::string(word.name) + " " + object + ")" : with(word.name, word.substance);
  return literal.empty() || !word.negated ? literal : "(not " + literal + ")";
}

std::string_view bddl_relation(Predicate predicate) {
  switch (predicate) {
    case Predicate::On:
      return "ontop";
    case Predicate::Inside:
      return "inside";
    case Predicate::NextTo:
      return "nextto";
    case Predicate::Under:
      return "under";
    case Predicate::Attached:
      return "attached";
    default:
      return "";
  }
}

}  // namespace unietp
