#include "sense/action_roles.h"

namespace unietp {

std::string_view action_of(Predicate predicate) {
  using enum Predicate;
  switch (predicate) {
    case Open:
      return "open";
    case Closed:
      return "close";
    case PowerOn:
      return "switch_on";
    case PowerOff:
      return "switch_off";
    case Clean:
      return "wash";
    case Dirty:
      return "soil";
    case Hot:
      return "heat";
    case Predicate::Cool:
      return "cool";
    case Cooked:
      return "cook";
    case Burnt:
      return "burn";
    case Frozen:
      return "freeze";
    case Sliced:
      return "slice";
    case Empty:
      return "empty";
    case Soaked:
      return "soak";
    case Dry:
      return "dry";
    case UsedUp:
      return "use_up";
    case Broken:
      return "break";
    case Folded:
      return "fold";
    case Unfolded:
      return "unfold";
    case PluggedIn:
      return "plug_in";
    case Unplugged:
      return "unplug";
    case Held:
      return "hold";
    case SatOn:
      return "sit";
    case LainOn:
      return "lie";
    case Predicate::Read:
      return "read";
    default:
      return "";
  }
}

}  // namespace unietp
