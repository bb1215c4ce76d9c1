#include "annotator/words_for_reading.h"

#include <algorithm>
#include <array>
#include <vector>

namespace unietp {
namespace {

using P = Predicate;

/// Forms are separated by '|'; in a verb "_" stands for its object, and a "?" at the end marks what may be left out.
struct ReadingRow {
  Predicate predicate;
  std::string_view states, prepositions, symbols, verbs;
  std::string_view evidence;       // see words_for
  std::string_view evidence_only;  // see words_only_for
};

constexpr std::array<ReadingRow, kPredicateCount> kReadingRows{{
    {P::Open, "open", "", "", "open up|open", "open", "open. opened. opening."},
    {P::Closed, "closed|shut|zipped-up", "", "", "close|shut", "clos shut zip lid.", "close. closed. closing. shut."},
    {P::PowerOn, "switched on|turned on", "", "", "turn on|switch on",
     "on. power switch turn activ start running lit light", ""},
    {P::PowerOff, "switched off|turned off", "", "", "turn off|switch off", "off. power switch turn deactiv stop out.",
     ""},
    {P::Clean, "clean|washed", "", "", "wash|clean", "clean wash rins scrub wip spotless dust",
     "wash. washed. washing. clean. cleaned. rinse. scrub."},
    {P::Dirty, "dirty", "", "", "make _ dirty", "dirt soil stain unwash unclean smear mess grim",
     "dirty. soiled. unwashed."},
    {P::Hot, "hot|heated|warm", "", "", "heat up|warm up|heat _ up?|warm _ up?", "hot heat warm boil steam microwav",
     "heat. heated. hot. warm. warmed."},
    {P::Cool, "cold|cool|chilled", "", "", "cool down|cool _ down?|chill", "cool cold chill fridg refrigerat",
     "cool. cold. chill. chilled. cooled."},
    {P::RoomTemperature, "at room temperature", "", "", "", "temperature", "temperature."},
    {P::Cooked, "cooked", "", "", "cook", "cook bak roast fry fried boil toast grill prepar done.",
     "cook. cooked. bake. baked. roast. fry."},
    {P::Raw, "raw", "", "", "", "raw uncook", "raw. uncooked."},
    {P::Burnt, "burnt", "", "", "char|burn", "burn char", "burn. burnt. burned. char. charred."},
    {P::Unburnt, "unburnt", "", "", "", "unburn burn", "unburnt."},
    {P::Frozen, "frozen", "", "", "freeze", "freez froz", "freeze. frozen."},
    {P::Thawed, "thawed", "", "", "thaw|defrost", "thaw defrost unfroz", "thaw. thawed. defrost. defrosted."},
    {P::Sliced, "sliced", "", "", "slice up|slice|cut up|cut _ into slices", "slic cut chop", "sliced. chop. chopped."},
    {P::Whole, "whole", "", "", "", "whole uncut unslic intact cut slic", "uncut."},
    {P::Empty, "empty", "", "", "empty out|empty|pour out", "empt pour drain tip nothing",
     "empty. emptied. pour. drain."},
    {P::Soaked, "soaked", "", "", "soak|wet", "soak wet drench", "soak. soaked. drench. drenched."},
    {P::Dry, "dry", "", "", "dry", "dry dri", "dry. dried."},
    {P::UsedUp, "used up", "", "", "use up", "use", "used-up."},
    {P::Unused, "unused", "", "", "", "unus use new.", "unused."},
    {P::Broken, "broken", "", "", "break", "break broke smash shatter", "break. broken. smash. shatter."},
    {P::Intact, "intact", "", "", "", "intact unbroken break broke undamag whole", "intact. unbroken."},
    {P::Folded, "folded", "", "", "fold up|fold", "fold", "fold. folded."},
    {P::Unfolded, "unfolded", "", "", "unfold", "unfold spread open", "unfold. unfolded."},
    {P::PluggedIn, "plugged in", "", "", "plug in|plug _ in", "plug", ""},
    {P::Unplugged, "unplugged", "", "", "unplug", "unplug plug disconnect", "unplug. unplugged."},
    {P::Held, "in your hand|in your hands|held", "", "",
     "pick up|pick _ up|end up holding|hold on to|hold|grab me|grab",
     "hold held hand pick carry carri grab grasp me. down. somewhere.", "hold. holding. held."},
    {P::SatOn, "sat on", "", "", "sit down on|sit on", "sit sat. seat", "sit. seated."},
    {P::LainOn, "lain on", "", "", "lie down on|lie on", "lie lying lain lay", "lie. lain. lying."},
    {P::Read, "read", "", "", "read", "read. reads. reading.", "read. reading."},
    {P::Filled, "", "", "filled with", "", "fill full pour into. contain with", "fill. filled."},
    {P::Covered, "", "", "covered with|covered in", "", "cover spread smear coat sprinkl wip",
     "cover. covered. spread. sprinkle."},
    {P::Color, "", "", "of the colour", "", "", ""},
    {P::Material, "", "", "made of", "", "", ""},
    {P::Size, "", "", "of the size", "", "larg big small tini tiny littl size",
     "larger. largest. bigger. biggest. smaller. smallest."},
    {P::On, "", "on top of|onto|on", "", "",
     "on. onto. upon. top. over. off. from. atop. stand surface divid split to.", ""},
    {P::Inside, "", "inside of|inside|into|in", "", "",
     "in. into. inside within. out. from. contain kept keep store fill full to.", ""},
    {P::NextTo, "", "next to|beside", "", "", "next. beside. near. by. adjacent. alongside.",
     "beside. alongside. adjacent."},
    {P::Under, "", "underneath|under", "", "", "under below beneath", "under. underneath. below. beneath."},
    {P::SliceOf, "", "cut from", "", "", "slice piece cut from. of.", ""},
    {P::Attached, "", "attached to", "", "", "attach fix fasten mount hang hung stick to.",
     "attach. attached. fasten. mount."},
    {P::Nearest, "", "nearest to|closest to", "", "", "near close", "nearest. closest."},
    {P::OnFloor, "", "on the floor of", "", "", "floor", "floor."},
    {P::InRoom, "", "", "", "", "in. into. to. from. enter room reach inside", ""},
}};

constexpr bool in_order_of_the_enum() {
  for (std::size_t i = 0; i < kReadingRows.size(); ++i) {
    if (static_cast<std::size_t>(kReadingRows[i].predicate) != i) return false;
  }
  return true;
}
static_assert(in_order_of_the_enum());

PredicatePhrase form_of(std::string_view text, Predicate predicate) {
  constexpr std::string_view kObject = " _ ";
  const auto gap = text.find(kObject);
  if (gap == std::string_view::npos) return {text, {}, false, predicate};
  std::string_view after = text.substr(gap + kObject.size());
  const bool optional = after.ends_with('?');
  if (optional) after.remove_suffix(1);
  return {text.substr(0, gap), after, optional, predicate};
}

/// All forms of one column, those of more words first.
std::vector<PredicatePhrase> forms(std::string_view ReadingRow::*column) {
  std::vector<PredicatePhrase> all;
  for (const ReadingRow& row : kReadingRows) {
    for (std::string_view rest = row.*column; !rest.empty();) {
      const auto end = std::min(rest.find('|'), rest.size());
      all.push_back(form_of(rest.substr(0, end), row.predicate));
      rest.remove_prefix(std::min(end + 1, rest.size()));
    }
  }
  const auto words = [](const PredicatePhrase& form) { return std::count(form.words.begin(), form.words.end(), ' '); };
  std::stable_sort(all.begin(), all.end(),
                   [&](const PredicatePhrase& a, const PredicatePhrase& b) { return words(a) > words(b); });
  return all;
}

}  // namespace

std::span<const PredicatePhrase> state_phrases() {
  static const auto all = forms(&ReadingRow::states);
  return all;
}

std::span<const PredicatePhrase> preposition_phrases() {
  static const auto all = forms(&ReadingRow::prepositions);
  return all;
}

std::span<const PredicatePhrase> symbol_phrases() {
  static const auto all = forms(&ReadingRow::symbols);
  return all;
}

std::span<const PredicatePhrase> verb_phrases() {
  static const auto all = forms(&ReadingRow::verbs);
  return all;
}

std::span<const PredicatePhrase> result_phrases() {
  static constexpr std::array<PredicatePhrase, 8> kResults{{{"washed", {}, false, P::Clean},
                                                            {"rinsed", {}, false, P::Clean},
                                                            {"heated", {}, false, P::Hot},
                                                            {"warmed", {}, false, P::Hot},
                                                            {"chilled", {}, false, P::Cool},
                                                            {"cooled", {}, false, P::Cool},
                                                            {"cooked", {}, true, P::Cooked},
                                                            {"soaked", {}, true, P::Soaked}}};
  return kResults;
}

std::string_view words_for(Predicate predicate) { return kReadingRows[static_cast<std::size_t>(predicate)].evidence; }

std::string_view words_only_for(Predicate predicate) {
  return kReadingRows[static_cast<std::size_t>(predicate)].evidence_only;
}

bool is_among(std::string_view word, std::string_view list) {
  while (!list.empty()) {
    const std::size_t blank = list.find(' ');
    std::string_view beginning = list.substr(0, blank);
    list = blank == std::string_view::npos ? std::string_view() : list.substr(blank + 1);
    const bool whole = beginning.ends_with('.');
    if (whole) beginning.remove_suffix(1);
    if (whole ? word == beginning : word.starts_with(beginning)) return true;
  }
  return false;
}

}  // namespace unietp
