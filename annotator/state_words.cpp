#include "annotator/state_words.h"

namespace unietp {

std::string state_word(Predicate predicate) {
  using P = Predicate;
  switch (predicate) {
    case P::Open:
      return "open";
    case P::Closed:
      return "closed";
    case P::PowerOn:
      return "switched on";
    case P::PowerOff:
      return "switched off";
    case P::Clean:
      return "clean";
    case P::Dirty:
      return "dirty";
    case P::Hot:
      return "hot";
    case P::Cool:
      return "cold";
    case P::RoomTemperature:
      return "at room temperature";
    case P::Cooked:
      return "cooked";
    case P::Raw:
      return "raw";
    case P::Burnt:
      return "burnt";
    case P::Unburnt:
      return "unburnt";
    case P::Frozen:
      return "frozen";
    case P::Thawed:
      return "thawed";
    case P::Sliced:
      return "sliced";
    case P::Whole:
      return "whole";
    case P::Empty:
      return "empty";
    case P::Soaked:
      return "soaked";
    case P::Dry:
      return "dry";
    case P::UsedUp:
      return "used up";
    case P::Unused:
      return "unused";
    case P::Broken:
      return "broken";
    case P::Intact:
      return "intact";
    case P::Folded:
      return "folded";
    case P::Unfolded:
      return "unfolded";
    case P::PluggedIn:
      return "plugged in";
    case P::Unplugged:
      return "unplugged";
    case P::Held:
      return "in your hand";
    case P::SatOn:
      return "sat on";
    case P::LainOn:
      return "lain on";
    default:
      return "";
  }
}

std::string before_object(Predicate predicate) {
  using P = Predicate;
  switch (predicate) {
    case P::On:
      return "on";
    case P::Inside:
    case P::InRoom:
      return "in";
    case P::NextTo:
      return "next to";
    case P::Under:
      return "under";
    case P::SliceOf:
      return "cut from";
    case P::Attached:
      return "attached to";
    case P::Nearest:
      return "nearest to";
    case P::OnFloor:
      return "on the floor of";
    default:
      return "";
  }
}

}  // namespace unietp
