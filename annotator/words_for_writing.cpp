#include "annotator/words_for_writing.h"

#include <array>

#include "core/text.h"

namespace unietp {
namespace {

using P = Predicate;

struct WritingRow {
  Predicate predicate;
  std::string_view state;        // after "is", of one object
  std::string_view preposition;  // after "is", before the second object
  std::array<std::string_view, 5> verbs = {};
};

constexpr WritingRow kWritingRows[] = {
    {P::Open, "open", "", {"open {s}", "open up {s}"}},
    {P::Closed, "closed", "", {"close {s}", "shut {s}"}},
    {P::PowerOn, "switched on", "", {"turn on {s}", "switch on {s}", "turn {s} on", "switch {s} on"}},
    {P::PowerOff, "switched off", "", {"turn off {s}", "switch off {s}", "turn {s} off", "switch {s} off"}},
    {P::Clean, "clean", "", {"clean {s}", "wash {s}"}},
    {P::Dirty, "dirty", "", {"make {s} dirty"}},
    {P::Hot, "hot", "", {"heat {s}", "heat up {s}", "heat {s} up"}},
    {P::Cool, "cold", "", {"cool {s}", "chill {s}", "cool {s} down", "cool down {s}"}},
    {P::RoomTemperature, "at room temperature", "", {}},
    {P::Cooked, "cooked", "", {"cook {s}"}},
    {P::Raw, "raw", "", {}},
    {P::Burnt, "burnt", "", {"char {s}"}},
    {P::Unburnt, "unburnt", "", {}},
    {P::Frozen, "frozen", "", {"freeze {s}"}},
    {P::Thawed, "thawed", "", {"thaw {s}", "defrost {s}"}},
    {P::Sliced, "sliced", "", {"slice {s}", "cut {s} into slices", "slice up {s}"}},
    {P::Whole, "whole", "", {}},
    {P::Empty, "empty", "", {"empty {s}", "pour out {s}"}},
    {P::Soaked, "soaked", "", {"soak {s}"}},
    {P::Dry, "dry", "", {"dry {s}"}},
    {P::UsedUp, "used up", "", {"use up {s}"}},
    {P::Unused, "unused", "", {}},
    {P::Broken, "broken", "", {"break {s}"}},
    {P::Intact, "intact", "", {}},
    {P::Folded, "folded", "", {"fold {s}", "fold up {s}"}},
    {P::Unfolded, "unfolded", "", {"unfold {s}"}},
    {P::PluggedIn, "plugged in", "", {"plug in {s}", "plug {s} in"}},
    {P::Unplugged, "unplugged", "", {"unplug {s}"}},
    {P::Held, "in your hand", "", {"pick up {s}", "pick {s} up", "hold {s}"}},
    {P::SatOn, "sat on", "", {"sit on {s}", "sit down on {s}"}},
    {P::LainOn, "lain on", "", {"lie on {s}", "lie down on {s}"}},
    {P::Read, "read", "", {"read {s}"}},
    {P::Filled, "", "", {"fill {s} with {m}"}},
    {P::Covered, "", "", {"cover {s} with {m}", "spread {m} over {s}"}},
    {P::On,
     "",
     "on",
     {"put {s} on {o}", "place {s} on {o}", "set {s} on {o}", "put {s} onto {o}", "place {s} on top of {o}"}},
    {P::Inside,
     "",
     "in",
     {"put {s} in {o}", "put {s} into {o}", "place {s} inside {o}", "put {s} inside {o}", "place {s} in {o}"}},
    {P::NextTo, "", "next to", {"put {s} next to {o}", "place {s} beside {o}", "set {s} next to {o}"}},
    {P::Under, "", "under", {"put {s} under {o}", "place {s} underneath {o}"}},
    {P::SliceOf, "", "cut from", {}},
    {P::Attached, "", "attached to", {"attach {s} to {o}"}},
    {P::Nearest, "", "nearest to", {}},
    {P::OnFloor, "", "on the floor of", {"put {s} on the floor of {o}", "place {s} on the floor of {o}"}},
    {P::InRoom, "", "in", {"bring {s} into {o}", "take {s} to {o}"}},
};

struct EverydayRow {
  Predicate predicate;
  std::array<std::string_view, 4> verbs = {};
};

/// Where people say it in fewer or other words than the table above has.
constexpr EverydayRow kEverydayRows[] = {
    {P::Open, {"open {s}"}},
    {P::Closed, {"close {s}"}},
    {P::PowerOn, {"turn on {s}", "turn {s} on"}},
    {P::PowerOff, {"turn off {s}", "turn {s} off"}},
    {P::Clean, {"wash {s}", "clean {s}"}},
    {P::Hot, {"heat {s}", "heat up {s}", "warm up {s}"}},
    {P::Cool, {"chill {s}"}},
    {P::Thawed, {"defrost {s}", "thaw {s}"}},
    {P::Sliced, {"slice {s}", "cut {s} into slices"}},
    {P::Empty, {"empty {s}"}},
    {P::Folded, {"fold {s}"}},
    {P::PluggedIn, {"plug in {s}", "plug {s} in"}},
    {P::Held, {"pick up {s}", "grab {s}"}},
    {P::SatOn, {"sit down on {s}", "sit on {s}"}},
    {P::LainOn, {"lie down on {s}"}},
    {P::On, {"put {s} on {o}", "place {s} on {o}", "move {s} to {o}"}},
    {P::Inside, {"put {s} in {o}", "place {s} in {o}", "move {s} into {o}"}},
    {P::NextTo, {"put {s} next to {o}", "place {s} next to {o}"}},
    {P::Under, {"put {s} under {o}"}},
    {P::OnFloor, {"put {s} on the floor of {o}"}},
    {P::InRoom, {"take {s} to {o}", "bring {s} to {o}", "move {s} to {o}"}},
};

const WritingRow& row_of(Predicate predicate) {
  static const auto kTable = [] {
    std::array<WritingRow, kPredicateCount> table{};
    for (const WritingRow& row : kWritingRows) table[static_cast<std::size_t>(row.predicate)] = row;
    return table;
  }();
  return kTable[static_cast<std::size_t>(predicate)];
}

}  // namespace

std::string state_word(Predicate predicate) { return std::string(row_of(predicate).state); }

std::string before_object(Predicate predicate) { return std::string(row_of(predicate).preposition); }

std::string symbol_words(const std::string& symbol) {
  if (symbol == "parmesan") return "Parmesan";
  return replace_all(symbol, "_", " ") + (symbol.ends_with("_seed") ? "s" : "");  // "sesame seeds"
}

bool is_drizzled(const std::string& substance) {
  return substance.ends_with("vinegar") || substance.ends_with("oil") || substance.ends_with("juice") ||
         substance == "soy_sauce";
}

std::string floor_of(const std::string& room, bool described) {
  if (room == "it") return "its floor";
  const bool article = room.starts_with("the ") || room.starts_with("a ") || room.starts_with("an ");
  return article && !described ? room + " floor" : "the floor of " + room;
}

std::vector<std::string> verbs(const Complement& said) {
  if (said.negated && said.predicate == P::Covered) return {"wipe the {m} off {s}"};
  std::vector<std::string> found;
  for (const std::string_view verb : row_of(said.predicate).verbs) {
    if (!said.negated && !verb.empty()) found.emplace_back(verb);
  }
  return found;
}

std::vector<std::string> everyday_verbs(const Complement& said) {
  if (said.predicate == P::Covered && said.negated) return {"wipe the {m} off {s}"};
  if (said.predicate == P::Filled && !said.negated && said.symbol != "any")
    return {"fill {s} with {m}", "pour {m} into {s}"};
  for (const EverydayRow& row : kEverydayRows) {
    if (row.predicate != said.predicate || said.negated) continue;
    std::vector<std::string> found;
    for (const std::string_view verb : row.verbs)
      if (!verb.empty()) found.emplace_back(verb);
    return found;
  }
  return verbs(said);
}

}  // namespace unietp
