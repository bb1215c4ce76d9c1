#include "akb/name_table.h"

#include <algorithm>

namespace unietp {

NameTable::NameTable(std::vector<std::string> names) : names_(std::move(names)) {
  if (!std::is_sorted(names_.begin(), names_.end())) std::sort(names_.begin(), names_.end());
  names_.erase(std::unique(names_.begin(), names_.end()), names_.end());
  slots_ = NameSlots(names_.size(), [&](std::uint32_t number) -> std::string_view { return names_[number]; });
}

std::uint32_t NameTable::number(std::string_view name) const {
  return slots_.find(name, [&](std::uint32_t number) -> std::string_view { return names_[number]; });
}

}  // namespace unietp
