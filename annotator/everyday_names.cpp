#include "annotator/everyday_names.h"

#include <algorithm>
#include <array>

namespace unietp {
namespace {

struct EverydayName {
  std::string_view name, us, gb;
};

/// In order of name.
constexpr std::array<EverydayName, 48> kEverydayNames{{
    {"aluminum foil", "aluminum foil", "aluminium foil"},
    {"band-aid", "band-aid", "plaster"},
    {"bin", "trash can", "bin"},
    {"bottom cabinet", "lower cabinet", "lower cupboard"},
    {"bottom cabinet without a top", "base cabinet", "base unit"},
    {"box of takeout", "box of takeout", "box of takeaway"},
    {"candy bar", "candy bar", "chocolate bar"},
    {"cell phone", "cell phone", "mobile phone"},
    {"closet", "closet", "wardrobe"},
    {"closet drawer", "closet drawer", "wardrobe drawer"},
    {"clothes dryer", "clothes dryer", "tumble dryer"},
    {"computer monitor", "monitor", "monitor"},
    {"condiment shaker", "spice shaker", "spice shaker"},
    {"countertop", "countertop", "worktop"},
    {"diaper", "diaper", "nappy"},
    {"dishtowel", "dish towel", "tea towel"},
    {"dresser", "dresser", "chest of drawers"},
    {"drop-in sink", "sink", "sink"},
    {"eggplant", "eggplant", "aubergine"},
    {"faucet", "faucet", "tap"},
    {"flashlight", "flashlight", "torch"},
    {"gym shoe", "sneaker", "trainer"},
    {"hardback book", "hardcover book", "hardback book"},
    {"heap of raisins", "pile of raisins", "pile of raisins"},
    {"kitchen counter", "kitchen counter", "worktop"},
    {"license plate", "license plate", "number plate"},
    {"mailbox", "mailbox", "letterbox"},
    {"nightstand", "nightstand", "bedside table"},
    {"oven stove", "stove", "cooker"},
    {"pair of pants", "pair of pants", "pair of trousers"},
    {"pair of trousers", "pair of pants", "pair of trousers"},
    {"power outlet", "power outlet", "socket"},
    {"rubber boot", "rubber boot", "wellington boot"},
    {"slice of eggplant", "slice of eggplant", "slice of aubergine"},
    {"soda cup", "soda cup", "fizzy drink cup"},
    {"stack of paper liners", "stack of paper liners", "stack of paper liners"},
    {"standing loudspeaker", "floor speaker", "floor speaker"},
    {"stroller", "stroller", "pushchair"},
    {"sugar cookie", "sugar cookie", "sugar biscuit"},
    {"table fork", "fork", "fork"},
    {"table television", "television", "television"},
    {"tap", "faucet", "tap"},
    {"top cabinet", "upper cabinet", "wall unit"},
    {"trash can", "trash can", "bin"},
    {"vest", "vest", "waistcoat"},
    {"washing sponge", "sponge", "sponge"},
    {"water glass", "glass", "glass"},
    {"zucchini", "zucchini", "courgette"},
}};
static_assert(std::is_sorted(kEverydayNames.begin(), kEverydayNames.end(),
                             [](const EverydayName& a, const EverydayName& b) { return a.name < b.name; }));

}  // namespace

std::string_view everyday_name(std::string_view name, English english) {
  const auto found = std::lower_bound(kEverydayNames.begin(), kEverydayNames.end(), name,
                                      [](const EverydayName& row, std::string_view key) { return row.name < key; });
  if (found == kEverydayNames.end() || found->name != name) return "";
  return english == English::Us ? found->us : found->gb;
}

}  // namespace unietp
