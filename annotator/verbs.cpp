#include "annotator/verbs.h"

namespace unietp {

std::vector<const char*> verbs(const Complement& said) {
  using P = Predicate;
  if (said.negated) {
    if (said.predicate == P::Covered) return {"wipe the {m} off {s}"};
    return {};
  }
  switch (said.predicate) {
    case P::Open:
      return {"open {s}", "open up {s}"};
    case P::Closed:
      return {"close {s}", "shut {s}"};
    case P::PowerOn:
      return {"turn on {s}", "switch on {s}", "turn {s} on", "switch {s} on"};
    case P::PowerOff:
      return {"turn off {s}", "switch off {s}", "turn {s} off", "switch {s} off"};
    case P::Clean:
      return {"clean {s}", "wash {s}"};
    case P::Dirty:
      return {"make {s} dirty"};
    case P::Hot:
      return {"heat {s}", "heat up {s}", "heat {s} up"};
    case P::Cool:
      return {"cool {s}", "chill {s}", "cool {s} down", "cool down {s}"};
    case P::Cooked:
      return {"cook {s}"};
    case P::Burnt:
      return {"burn {s}"};
    case P::Frozen:
      return {"freeze {s}"};
    case P::Thawed:
      return {"thaw {s}", "defrost {s}"};
    case P::Sliced:
      return {"slice {s}", "cut {s} into slices", "slice up {s}"};
    case P::Empty:
      return {"empty {s}", "pour out {s}"};
    case P::Soaked:
      return {"soak {s}"};
    case P::Dry:
      return {"dry {s}"};
    case P::UsedUp:
      return {"use up {s}"};
    case P::Broken:
      return {"break {s}"};
    case P::Folded:
      return {"fold {s}", "fold up {s}"};
    case P::Unfolded:
      return {"unfold {s}"};
    case P::PluggedIn:
      return {"plug in {s}", "plug {s} in"};
    case P::Unplugged:
      return {"unplug {s}"};
    case P::Held:
      return {"pick up {s}", "pick {s} up", "hold {s}"};
    case P::SatOn:
      return {"sit on {s}", "sit down on {s}"};
    case P::LainOn:
      return {"lie on {s}", "lie down on {s}"};
    case P::Filled:
      return {"fill {s} with {m}"};
    case P::Covered:
      return {"cover {s} with {m}", "spread {m} over {s}"};
    case P::On:
      return {"put {s} on {o}", "place {s} on {o}", "set {s} on {o}", "put {s} onto {o}", "place {s} on top of {o}"};
    case P::Inside:
      return {"put {s} in {o}", "put {s} into {o}", "place {s} inside {o}", "put {s} inside {o}", "place {s} in {o}"};
    case P::NextTo:
      return {"put {s} next to {o}", "place {s} beside {o}", "set {s} next to {o}"};
    case P::Under:
      return {"put {s} under {o}", "place {s} underneath {o}"};
    case P::OnFloor:
      return {"put {s} on the floor of {o}", "place {s} on the floor of {o}"};
    case P::InRoom:
      return {"bring {s} into {o}", "take {s} to {o}"};
    case P::Attached:
      return {"attach {s} to {o}"};
    default:
      return {};
  }
}

}  // namespace unietp
