#include "python/native/array_form.h"

#include <algorithm>
#include <cmath>

#include "scene/action.h"

namespace unietp::python {
namespace {

enum Kind : std::int32_t { kRoom = 1, kFurniture = 2, kMovable = 3, kSeen = 4 };

std::int32_t position_of(const std::vector<std::string>& names, std::string_view name) {
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? -1 : static_cast<std::int32_t>(found - names.begin());
}

int pixel_of(double part, int pixels) {
  return std::isfinite(part) ? static_cast<int>(std::lround(std::clamp(part, 0.0, 1.0) * std::max(pixels - 1, 0))) : 0;
}

}  // namespace

Vocabulary::Vocabulary(std::vector<std::string> names) : names_(std::move(names)) {}

std::int32_t Vocabulary::number_of(std::string_view name) const {
  const auto found = std::lower_bound(names_.begin(), names_.end(), name);
  return found == names_.end() || *found != name ? 0 : static_cast<std::int32_t>(found - names_.begin()) + 1;
}

void ArrayForm::add(const NamedEntity& thing, std::int32_t kind) {
  if (row_of(thing.id)) return;
  if (ids_.size() == rows_) {
    complete_ = false;
    return;
  }
  row_by_id_.emplace(thing.id, ids_.size());
  ids_.push_back(thing.id);
  known_.push_back({kind, vocabulary_->number_of(thing.category)});
}

std::optional<std::size_t> ArrayForm::row_of(std::string_view id) const {
  const auto found = row_by_id_.find(std::string(id));
  return found == row_by_id_.end() ? std::nullopt : std::optional(found->second);
}

void ArrayForm::begin(const Observation& first) {
  ids_.clear();
  known_.clear();
  row_by_id_.clear();
  complete_ = true;
  for (const auto& thing : first.home->rooms) add(thing, kRoom);
  for (const auto& thing : first.home->furniture) add(thing, kFurniture);
  for (const auto& thing : first.home->movables) add(thing, kMovable);
  see(first);
}

void ArrayForm::see(const Observation& observation) {
  if (!observation.boxes) return;
  for (const auto& seen : *observation.boxes) add({seen.id, seen.category}, kSeen);
}

void ArrayForm::write(const Observation& observation, const ObservationArrays& arrays) const {
  std::ranges::fill(arrays.things, 0);
  for (std::size_t row = 0; row < rows_; ++row) {
    const auto cells = arrays.things.subspan(row * kThingColumns, kThingColumns);
    std::ranges::fill(cells.subspan(3), -1);
    if (row < known_.size()) {
      cells[0] = known_[row].kind;
      cells[1] = known_[row].category;
    }
  }
  if (observation.boxes) {
    for (const auto& seen : *observation.boxes) {
      const auto row = row_of(seen.id);
      if (!row) continue;
      const auto cells = arrays.things.subspan(*row * kThingColumns, kThingColumns);
      cells[2] = 1;
      std::ranges::copy(seen.box, cells.begin() + 3);
    }
  }
  std::ranges::fill(arrays.held, 0);
  if (observation.held) {
    for (std::size_t i = 0; i < std::min(observation.held->size(), kHeldRows); ++i) {
      const auto& thing = (*observation.held)[i];
      const auto row = row_of(thing.id);
      arrays.held[i * kHeldColumns] = row ? static_cast<std::int32_t>(*row) + 1 : 0;
      arrays.held[i * kHeldColumns + 1] = vocabulary_->number_of(thing.category);
    }
  }
  std::ranges::fill(arrays.last, 0);
  if (observation.last) {
    const auto& last = *observation.last;
    arrays.last[0] = position_of(*actions_, std::string_view(last.action).substr(0, last.action.find('('))) + 1;
    arrays.last[1] = last.success ? (*last.success ? 2 : 1) : 0;
    arrays.last[2] = static_cast<std::int32_t>(last.failure);
  }
  arrays.counts[0] = observation.step;
  arrays.counts[1] = observation.steps_left;
  arrays.counts[2] = observation.failures_left.value_or(-1);
  std::ranges::fill(arrays.instruction, std::uint8_t{0});
  std::copy_n(observation.instruction.begin(), std::min(observation.instruction.size(), arrays.instruction.size()),
              arrays.instruction.begin());
}

Command ArrayForm::command_of(const NumberedAction& numbers, const ModeRules& rules,
                              const Observation& observation) const {
  const bool known = numbers.action >= 0 && static_cast<std::size_t>(numbers.action) < actions_->size();
  Command command{known ? (*actions_)[static_cast<std::size_t>(numbers.action)] : "no_such_action", {}};
  const auto type = known ? action_named(command.action) : std::nullopt;
  if (!type || info(*type).argument == ActionArgument::None) return command;
  if (numbers.argument == 0 && naming_of(info(*type), rules) == Naming::Box) {
    const auto [x0, y0, x1, y1] = numbers.box;
    command.args.push_back(
        {"", PixelBox{pixel_of(x0, observation.image_width), pixel_of(y0, observation.image_height),
                      pixel_of(x1, observation.image_width), pixel_of(y1, observation.image_height)}});
    return command;
  }
  const bool in_use = numbers.argument > 0 && static_cast<std::size_t>(numbers.argument) <= ids_.size();
  command.args.push_back({in_use ? ids_[static_cast<std::size_t>(numbers.argument) - 1] : "no_such_thing", {}});
  return command;
}

}  // namespace unietp::python
