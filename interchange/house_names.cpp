#include "interchange/house_names.h"

#include <cctype>

namespace unietp {

std::string room_type_from_procthor(std::string_view type) {
  std::string name;
  for (const char c : type) {
    if (std::isupper(static_cast<unsigned char>(c)) != 0 && !name.empty()) name += '_';
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) {
      name += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
  }
  return name.empty() ? "room" : name;
}

std::string room_type_to_procthor(std::string_view type) {
  for (const std::string_view kitchen : {"kitchen", "pantry"}) {
    if (type.find(kitchen) != std::string_view::npos) return "Kitchen";
  }
  for (const std::string_view wet : {"bath", "toilet", "laundry", "washroom", "utility"}) {
    if (type.find(wet) != std::string_view::npos) return "Bathroom";
  }
  if (type.find("bed") != std::string_view::npos || type.find("child") != std::string_view::npos) return "Bedroom";
  return "LivingRoom";
}

}  // namespace unietp
