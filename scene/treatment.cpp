#include "scene/treatment.h"

#include <array>

namespace unietp {
namespace {

using P = Predicate;
using A = ActionType;

constexpr std::array kHeats{P::Hot};
constexpr std::array kCools{P::Cool};
constexpr std::array kFreezes{P::Frozen, P::Cool};
constexpr std::array kCooks{P::Cooked, P::Hot};
constexpr std::array kBurns{P::Burnt, P::Hot};
constexpr std::array kWashes{P::Clean};
constexpr std::array kSoaks{P::Soaked};
constexpr std::array kFills{P::Filled};

constexpr std::array<TreatmentInfo, kTreatments> kTable{{
    {Treatment::Heats, "heats", A::HeatWith, {}, kHeats},
    {Treatment::Cools, "cools", A::CoolWith, {}, kCools},
    {Treatment::Freezes, "freezes", A::CoolWith, {}, kFreezes},
    {Treatment::Cooks, "cooks", A::CookWith, {}, kCooks},
    {Treatment::Burns, "burns", A::BurnWith, {}, kBurns},
    {Treatment::Washes, "washes", A::WashWith, {}, kWashes},
    {Treatment::Soaks, "soaks", A::SoakWith, {}, kSoaks},
    {Treatment::Fills, "fills", A::FillWith, {}, kFills},
    {Treatment::Slices, "slices", {}, A::Slice, {}},
    {Treatment::Wipes, "wipes", {}, A::Wipe, {}},
    {Treatment::Dispenses, "dispenses", {}, A::SpreadTo, {}},
    {Treatment::Drains, "drains", {}, {}, {}},
    {Treatment::Attaches, "attaches", {}, {}, {}},
}};

constexpr bool in_order_of_the_enum() {
  for (std::size_t i = 0; i < kTable.size(); ++i) {
    if (static_cast<std::size_t>(kTable[i].treatment) != i) return false;
  }
  return true;
}
static_assert(in_order_of_the_enum());

}  // namespace

const TreatmentInfo& info(Treatment treatment) { return kTable[static_cast<std::size_t>(treatment)]; }
std::span<const TreatmentInfo> all_treatments() { return kTable; }
std::string_view name_of(Treatment treatment) { return info(treatment).name; }

std::optional<Treatment> treatment_named(std::string_view name) {
  for (const TreatmentInfo& row : kTable) {
    if (row.name == name) return row.treatment;
  }
  return std::nullopt;
}

std::span<const Predicate> sets(Treatment treatment) { return info(treatment).states; }
std::optional<ActionType> action_for(Treatment treatment) { return info(treatment).treats; }

}  // namespace unietp
