#include "run/homes_of_slots.h"

#include <algorithm>

#include "run/make_home.h"
#include "run/slots.h"

namespace unietp {

Result<HomesOfSlots> HomesOfSlots::of(const RunConfiguration& configuration, const Resources& resources) {
  const auto slots = plan_slots(configuration, resources);
  if (!slots) return slots.error();
  return HomesOfSlots(configuration, resources, blocks_of(configuration, resources, *slots));
}

bool HomesOfSlots::may_fill(int slot, std::string_view home) const {
  const auto block = std::find_if(blocks_.begin(), blocks_.end(), [&](const Block& one) {
    return one.first() <= slot && slot < one.first() + static_cast<int>(one.slots.size());
  });
  const auto number = home_number(configuration_, resources_, home);
  if (block == blocks_.end() || !number) return false;
  const HomeRange& homes = block->homes[static_cast<std::size_t>(number->first)];
  return homes.first <= number->second && number->second < homes.first + homes.count;
}

}  // namespace unietp
