#include "templates/purposes.h"

#include <algorithm>
#include <array>

namespace unietp {
namespace {

using enum Predicate;

constexpr std::array kTidying{
    PurposeSign{On},           PurposeSign{Inside},        PurposeSign{NextTo}, PurposeSign{Under},
    PurposeSign{InRoom},       PurposeSign{Closed},        PurposeSign{Folded}, PurposeSign{On, true},
    PurposeSign{Inside, true}, PurposeSign{OnFloor, true}, PurposeSign{OnFloor}};
constexpr std::array kStoring{PurposeSign{On}, PurposeSign{Inside}, PurposeSign{Closed}, PurposeSign{Frozen}};
constexpr std::array kFetching{PurposeSign{On},     PurposeSign{Inside}, PurposeSign{NextTo},      PurposeSign{OnFloor},
                               PurposeSign{InRoom}, PurposeSign{Held},   PurposeSign{Inside, true}};
constexpr std::array kServing{PurposeSign{On},  PurposeSign{Inside},          PurposeSign{InRoom},
                              PurposeSign{Hot}, PurposeSign{Predicate::Cool}, PurposeSign{Filled},
                              PurposeSign{Held}};
constexpr std::array kCooking{PurposeSign{Hot},     PurposeSign{Predicate::Cool}, PurposeSign{Cooked},
                              PurposeSign{Frozen},  PurposeSign{Sliced},          PurposeSign{SliceOf},
                              PurposeSign{Covered}, PurposeSign{Inside},          PurposeSign{On},
                              PurposeSign{Broken},  PurposeSign{Burnt},           PurposeSign{PowerOn}};
constexpr std::array kDrinks{PurposeSign{Filled}, PurposeSign{Hot}, PurposeSign{Predicate::Cool}, PurposeSign{PowerOn}};
constexpr std::array kCleaning{PurposeSign{Clean},  PurposeSign{Soaked},       PurposeSign{Dry},
                               PurposeSign{Empty},  PurposeSign{Filled, true}, PurposeSign{Covered, true},
                               PurposeSign{Filled}, PurposeSign{Inside},       PurposeSign{PowerOn}};
constexpr std::array kLaundry{PurposeSign{Clean},  PurposeSign{Soaked}, PurposeSign{Dry},    PurposeSign{Folded},
                              PurposeSign{Inside}, PurposeSign{On},     PurposeSign{PowerOn}};
constexpr std::array kComfort{PurposeSign{PowerOn},   PurposeSign{PowerOff}, PurposeSign{Open},   PurposeSign{Closed},
                              PurposeSign{PluggedIn}, PurposeSign{SatOn},    PurposeSign{LainOn}, PurposeSign{On},
                              PurposeSign{Burnt},     PurposeSign{Unfolded}};
constexpr std::array kLeisure{
    PurposeSign{PowerOn}, PurposeSign{Predicate::Read}, PurposeSign{SatOn}, PurposeSign{LainOn},
    PurposeSign{On},      PurposeSign{InRoom},          PurposeSign{Held},  PurposeSign{Open}};
constexpr std::array kPreparing{PurposeSign{Open},     PurposeSign{PowerOn}, PurposeSign{PluggedIn},
                                PurposeSign{Unfolded}, PurposeSign{Filled},  PurposeSign{On},
                                PurposeSign{Attached}, PurposeSign{Clean},   PurposeSign{Held}};
constexpr std::array kSaving{PurposeSign{PowerOff}, PurposeSign{Closed}, PurposeSign{Unplugged}, PurposeSign{UsedUp}};
constexpr std::array kSafety{
    PurposeSign{PowerOff}, PurposeSign{Closed},       PurposeSign{Unplugged},    PurposeSign{Inside},
    PurposeSign{On},       PurposeSign{On, true},     PurposeSign{Inside, true}, PurposeSign{OnFloor, true},
    PurposeSign{Empty},    PurposeSign{Filled, true}, PurposeSign{Covered, true}};

constexpr std::array<PurposeKind, 13> kPurposes = {{
    {"tidying", "things go where they belong", kTidying},
    {"storing", "food and supplies are kept where they last", kStoring},
    {"fetching", "a thing or the agent comes where a person needs it", kFetching},
    {"serving", "food, drinks and what is needed to eat them come to the table", kServing},
    {"cooking", "food is cut, warmed, cooled or cooked", kCooking},
    {"drinks", "drinks are made and poured", kDrinks},
    {"cleaning", "dirt goes from things and surfaces", kCleaning},
    {"laundry", "clothes and linen are washed, folded and put away", kLaundry},
    {"comfort", "light, warmth, air and rest", kComfort, true},
    {"leisure", "reading, listening, watching, playing", kLeisure, true},
    {"preparing", "something is made ready for use", kPreparing, true},
    {"saving", "nothing runs or stands open for no reason", kSaving},
    {"safety", "a danger is removed", kSafety, false, true},
}};

}  // namespace

std::span<const PurposeKind> purpose_kinds() { return kPurposes; }

const PurposeKind* purpose_kind(std::string_view name) {
  const auto* found =
      std::find_if(kPurposes.begin(), kPurposes.end(), [&](const PurposeKind& one) { return one.name == name; });
  return found == kPurposes.end() ? nullptr : found;
}

}  // namespace unietp
