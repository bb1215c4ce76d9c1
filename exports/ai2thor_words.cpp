#include "exports/ai2thor_words.h"

#include <algorithm>
#include <array>

namespace unietp {
namespace {

using namespace std::string_view_literals;

constexpr std::array kThorStates{ThorState{Predicate::Open, "isOpen", true, "OpenObject"},
                                 ThorState{Predicate::Closed, "isOpen", false, "CloseObject"},
                                 ThorState{Predicate::PowerOn, "isToggled", true, "ToggleObjectOn"},
                                 ThorState{Predicate::PowerOff, "isToggled", false, "ToggleObjectOff"},
                                 ThorState{Predicate::Clean, "isDirty", false, "CleanObject"},
                                 ThorState{Predicate::Dirty, "isDirty", true, "DirtyObject"},
                                 ThorState{Predicate::Hot, "temperature", "Hot"sv},
                                 ThorState{Predicate::Cool, "temperature", "Cold"sv},
                                 ThorState{Predicate::RoomTemperature, "temperature", "RoomTemp"sv},
                                 ThorState{Predicate::Cooked, "isCooked", true, "CookObject"},
                                 ThorState{Predicate::Raw, "isCooked", false},
                                 ThorState{Predicate::Sliced, "isSliced", true, "SliceObject"},
                                 ThorState{Predicate::Whole, "isSliced", false},
                                 ThorState{Predicate::Empty, "isFilledWithLiquid", false, "EmptyLiquidFromObject"},
                                 ThorState{Predicate::Filled, "fillLiquid", ""sv, "FillObjectWithLiquid"},
                                 ThorState{Predicate::UsedUp, "isUsedUp", true, "UseUpObject"},
                                 ThorState{Predicate::Unused, "isUsedUp", false},
                                 ThorState{Predicate::Broken, "isBroken", true, "BreakObject"},
                                 ThorState{Predicate::Intact, "isBroken", false},
                                 ThorState{Predicate::Held, "isPickedUp", true, "PickupObject"}};

constexpr std::array kThorMove{ThorCall{"Teleport", ThorTarget::Pose}};
constexpr std::array kThorPickUp{ThorCall{"PickupObject", ThorTarget::Argument}};
constexpr std::array kThorPut{ThorCall{"PutObject", ThorTarget::Argument}};
constexpr std::array kThorDrop{ThorCall{"DropHandObject"}};
constexpr std::array kThorOpen{ThorCall{"OpenObject", ThorTarget::Argument}};
constexpr std::array kThorClose{ThorCall{"CloseObject", ThorTarget::Argument}};
constexpr std::array kThorTurnOn{ThorCall{"ToggleObjectOn", ThorTarget::Argument}};
constexpr std::array kThorTurnOff{ThorCall{"ToggleObjectOff", ThorTarget::Argument}};
constexpr std::array kThorSlice{ThorCall{"SliceObject", ThorTarget::Argument}};
constexpr std::array kThorUseUp{ThorCall{"UseUpObject", ThorTarget::Argument}};
constexpr std::array kThorBreak{ThorCall{"BreakObject", ThorTarget::Argument}};
constexpr std::array kThorPour{ThorCall{"EmptyLiquidFromObject", ThorTarget::Held},
                               ThorCall{"FillObjectWithLiquid", ThorTarget::Argument, ThorWhen::Fills}};
constexpr std::array kThorInMicrowave{ThorCall{"OpenObject", ThorTarget::Argument, ThorWhen::Closed},
                                      ThorCall{"PutObject", ThorTarget::Argument},
                                      ThorCall{"CloseObject", ThorTarget::Argument},
                                      ThorCall{"ToggleObjectOn", ThorTarget::Argument},
                                      ThorCall{"ToggleObjectOff", ThorTarget::Argument},
                                      ThorCall{"OpenObject", ThorTarget::Argument},
                                      ThorCall{"PickupObject", ThorTarget::Held},
                                      ThorCall{"CloseObject", ThorTarget::Argument, ThorWhen::Closes}};
constexpr std::array kThorInFridge{ThorCall{"OpenObject", ThorTarget::Argument, ThorWhen::Closed},
                                   ThorCall{"PutObject", ThorTarget::Argument},
                                   ThorCall{"CloseObject", ThorTarget::Argument},
                                   ThorCall{"OpenObject", ThorTarget::Argument},
                                   ThorCall{"PickupObject", ThorTarget::Held},
                                   ThorCall{"CloseObject", ThorTarget::Argument, ThorWhen::Closes}};
constexpr std::array kThorInMachine{
    ThorCall{"PutObject", ThorTarget::Argument}, ThorCall{"ToggleObjectOff", ThorTarget::Argument, ThorWhen::Running},
    ThorCall{"ToggleObjectOn", ThorTarget::Argument}, ThorCall{"ToggleObjectOff", ThorTarget::Argument},
    ThorCall{"PickupObject", ThorTarget::Held}};
constexpr std::array kThorAtTap{ThorCall{"CleanObject", ThorTarget::Held, ThorWhen::Cleans},
                                ThorCall{"FillObjectWithLiquid", ThorTarget::Held, ThorWhen::Fills},
                                ThorCall{"CleanObject", ThorTarget::Others, ThorWhen::Cleans},
                                ThorCall{"FillObjectWithLiquid", ThorTarget::Others, ThorWhen::Fills}};

constexpr std::array kThorActions{ThorActionRow{ActionType::MoveForward, "", kThorMove},
                                  ThorActionRow{ActionType::MoveBackward, "", kThorMove},
                                  ThorActionRow{ActionType::MoveLeft, "", kThorMove},
                                  ThorActionRow{ActionType::MoveRight, "", kThorMove},
                                  ThorActionRow{ActionType::TurnLeft, "", kThorMove},
                                  ThorActionRow{ActionType::TurnRight, "", kThorMove},
                                  ThorActionRow{ActionType::LookUp, "", kThorMove},
                                  ThorActionRow{ActionType::LookDown, "", kThorMove},
                                  ThorActionRow{ActionType::GoTo, "", kThorMove},
                                  ThorActionRow{ActionType::TurnTo, "", kThorMove},
                                  ThorActionRow{ActionType::PickUp, "", kThorPickUp},
                                  ThorActionRow{ActionType::PlaceOn, "", kThorPut},
                                  ThorActionRow{ActionType::PlaceIn, "", kThorPut},
                                  ThorActionRow{ActionType::Drop, "", kThorDrop},
                                  ThorActionRow{ActionType::Open, "", kThorOpen},
                                  ThorActionRow{ActionType::Close, "", kThorClose},
                                  ThorActionRow{ActionType::TurnOn, "", kThorTurnOn},
                                  ThorActionRow{ActionType::TurnOff, "", kThorTurnOff},
                                  ThorActionRow{ActionType::Slice, "", kThorSlice},
                                  ThorActionRow{ActionType::UseUp, "", kThorUseUp},
                                  ThorActionRow{ActionType::Break, "", kThorBreak},
                                  ThorActionRow{ActionType::PourTo, "", kThorPour},
                                  ThorActionRow{ActionType::HeatWith, "Microwave", kThorInMicrowave},
                                  ThorActionRow{ActionType::HeatWith, "Toaster", kThorInMachine},
                                  ThorActionRow{ActionType::HeatWith, "CoffeeMachine", kThorInMachine},
                                  ThorActionRow{ActionType::CookWith, "Microwave", kThorInMicrowave},
                                  ThorActionRow{ActionType::CookWith, "Toaster", kThorInMachine},
                                  ThorActionRow{ActionType::CoolWith, "Fridge", kThorInFridge},
                                  ThorActionRow{ActionType::FillWith, "CoffeeMachine", kThorInMachine},
                                  ThorActionRow{ActionType::FillWith, "", kThorAtTap},
                                  ThorActionRow{ActionType::WashWith, "", kThorAtTap}};

}  // namespace

std::span<const ThorState> thor_states() { return kThorStates; }
std::span<const ThorActionRow> thor_actions() { return kThorActions; }

const ThorState* thor_state(Predicate state) {
  const auto* const row =
      std::find_if(kThorStates.begin(), kThorStates.end(), [&](const ThorState& one) { return one.state == state; });
  return row == kThorStates.end() ? nullptr : row;
}

std::optional<std::span<const ThorCall>> thor_calls(ActionType action, std::string_view tool) {
  for (const ThorActionRow& row : kThorActions) {
    if (row.action == action && (row.tool.empty() || row.tool == tool)) return row.calls;
  }
  return std::nullopt;
}

std::string_view thor_holding_part(std::string_view category) {
  if (category == "Sink") return "SinkBasin";
  if (category == "Bathtub") return "BathtubBasin";
  return {};
}

}  // namespace unietp
