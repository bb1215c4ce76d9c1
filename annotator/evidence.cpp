#include "annotator/evidence.h"

namespace unietp {
namespace {

using P = Predicate;

struct Evidence {
  Predicate predicate;
  std::string_view all, only;
};

constexpr Evidence kEvidence[] = {
    {P::Open, "open", "open. opened. opening."},
    {P::Closed, "clos shut", "close. closed. closing. shut."},
    {P::PowerOn, "on. power switch turn activ start running lit light", ""},
    {P::PowerOff, "off. power switch turn deactiv stop out.", ""},
    {P::Clean, "clean wash rins scrub wip spotless dust", "wash. washed. washing. clean. cleaned. rinse. scrub."},
    {P::Dirty, "dirt soil stain unwash unclean smear mess grim", "dirty. soiled. unwashed."},
    {P::Hot, "hot heat warm boil steam microwav", "heat. heated. hot. warm. warmed."},
    {P::Cool, "cool cold chill fridg refrigerat", "cool. cold. chill. chilled. cooled."},
    {P::RoomTemperature, "temperature", "temperature."},
    {P::Cooked, "cook bak roast fry fried boil toast grill prepar done.", "cook. cooked. bake. baked. roast. fry."},
    {P::Raw, "raw uncook", "raw. uncooked."},
    {P::Burnt, "burn char", "burn. burnt. burned. charred."},
    {P::Unburnt, "unburn burn", "unburnt."},
    {P::Frozen, "freez froz", "freeze. frozen."},
    {P::Thawed, "thaw defrost unfroz", "thaw. thawed. defrost. defrosted."},
    {P::Sliced, "slic cut chop", "sliced. chop. chopped."},
    {P::Whole, "whole uncut unslic intact cut slic", "uncut."},
    {P::Empty, "empt pour drain tip nothing", "empty. emptied. pour. drain."},
    {P::Soaked, "soak wet drench", "soak. soaked. drench. drenched."},
    {P::Dry, "dry dri", "dry. dried."},
    {P::UsedUp, "use", "used-up."},
    {P::Unused, "unus use new.", "unused."},
    {P::Broken, "break broke smash shatter", "break. broken. smash. shatter."},
    {P::Intact, "intact unbroken break broke undamag whole", "intact. unbroken."},
    {P::Folded, "fold", "fold. folded."},
    {P::Unfolded, "unfold spread open", "unfold. unfolded."},
    {P::PluggedIn, "plug", ""},
    {P::Unplugged, "unplug plug disconnect", "unplug. unplugged."},
    {P::Held, "hold held hand pick carry carri grab grasp", "hold. holding. held."},
    {P::SatOn, "sit sat. seat", "sit. seated."},
    {P::LainOn, "lie lying lain lay", "lie. lain. lying."},
    {P::Filled, "fill full pour contain with", "fill. filled."},
    {P::Covered, "cover spread smear coat wip", "cover. covered. spread."},
    {P::Colour, "", ""},
    {P::Material, "", ""},
    {P::Size, "larg big small tini tiny littl size", "larger. largest. bigger. biggest. smaller. smallest."},
    {P::On, "on. onto. upon. top. over. off. from. atop. stand surface", ""},
    {P::Inside, "in. into. inside within. out. from. contain kept keep store fill full", ""},
    {P::NextTo, "next. beside. near. by. adjacent. alongside.", "beside. alongside. adjacent."},
    {P::Under, "under below beneath", "under. underneath. below. beneath."},
    {P::SliceOf, "slice piece cut from. of.", ""},
    {P::Attached, "attach fix fasten mount hang hung stick to.", "attach. attached. fasten. mount."},
    {P::Nearest, "near close", "nearest. closest."},
    {P::OnFloor, "floor", "floor."},
    {P::InRoom, "in. into. to. from. enter room reach inside", ""},
};

const Evidence* evidence_of(Predicate predicate) {
  for (const Evidence& evidence : kEvidence)
    if (evidence.predicate == predicate) return &evidence;
  return nullptr;
}

}  // namespace

std::string_view words_for(Predicate predicate) {
  const Evidence* evidence = evidence_of(predicate);
  return evidence == nullptr ? "" : evidence->all;
}

std::string_view words_only_for(Predicate predicate) {
  const Evidence* evidence = evidence_of(predicate);
  return evidence == nullptr ? "" : evidence->only;
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
