#include "sense/action_roles.h"

namespace unietp {
namespace {

using P = Predicate;

constexpr StateAction kStateActions[] = {
    {P::Open, "open", {"open"}},
    {P::Closed, "close", {"close"}},
    {P::PowerOn, "switch_on", {"switch on"}},
    {P::PowerOff, "switch_off", {"switch off"}},
    {P::Clean, "wash", {"wash", "clean"}},
    {P::Dirty, "soil", {"soil"}},
    {P::Hot, "heat", {"heat"}},
    {P::Cool, "cool", {"cool"}},
    {P::Cooked, "cook", {"cook"}},
    {P::Burnt, "burn", {"burn"}},
    {P::Frozen, "freeze", {"freeze"}},
    {P::Sliced, "slice", {"slice"}},
    {P::Empty, "empty", {"empty"}},
    {P::Soaked, "soak", {"soak"}},
    {P::Dry, "dry", {"dry"}},
    {P::UsedUp, "use_up", {"use up"}},
    {P::Broken, "break", {"break"}},
    {P::Folded, "fold", {"fold"}},
    {P::Unfolded, "unfold", {"unfold"}},
    {P::PluggedIn, "plug_in", {"plug in"}},
    {P::Unplugged, "unplug", {"unplug"}},
    {P::Held, "hold", {"pick up", "hold"}},
    {P::SatOn, "sit", {"sit on"}},
    {P::LainOn, "lie", {"lie on"}},
    {P::Read, "read", {"read"}},
};

}  // namespace

std::span<const StateAction> state_actions() { return kStateActions; }

std::string_view action_of(Predicate predicate) {
  for (const StateAction& row : kStateActions) {
    if (row.predicate == predicate) return row.role;
  }
  return "";
}

}  // namespace unietp
