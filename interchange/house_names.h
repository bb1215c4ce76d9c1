#pragma once

#include <array>
#include <string>
#include <string_view>

namespace unietp {

// ProcTHOR knows four kinds of rooms; ours are named after them, and theirs after ours.

/// As its files write them.
inline constexpr std::array<std::string_view, 4> kProcthorRooms{"Bathroom", "Bedroom", "Kitchen", "LivingRoom"};

/// "LivingRoom" → "living_room"; a kind that it does not know likewise.
std::string room_type_from_procthor(std::string_view type);
/// "dining_room" → "LivingRoom": the one of kProcthorRooms that a room of ours comes nearest to.
std::string room_type_to_procthor(std::string_view type);

}  // namespace unietp
