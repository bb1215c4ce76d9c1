#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "environment/observation.h"
#include "environment/settings.h"
#include "scene/command.h"

namespace unietp::python {

/// Columns of the array `things`, int32: kind (0 no row, 1 room, 2 furniture, 3 movable), category (its number in
/// Vocabulary), in view (0 or 1), and the box in view x0, y0, x1, y1 in pixels, both ends included; -1 when not in
/// view.
inline constexpr std::size_t kThingColumns = 7;
inline constexpr std::size_t kHeldRows = 2;      // as many as an agent has hands
inline constexpr std::size_t kHeldColumns = 2;   // row in `things` + 1 (0: none, or not known), category
inline constexpr std::size_t kLastNumbers = 3;   // action + 1, success + 1 (0: not told), number of the failure
inline constexpr std::size_t kCountNumbers = 3;  // step, steps left, failures left (-1: hidden)

/// Numbers of categories and of room types. 0 is what has none.
class Vocabulary {
 public:
  /// `names`: sorted, no name twice.
  explicit Vocabulary(std::vector<std::string> names);
  std::int32_t number_of(std::string_view name) const;
  const std::vector<std::string>& names() const { return names_; }

 private:
  std::vector<std::string> names_;
};

/// Where an observation is written to. The caller owns the memory; sizes in numbers.
struct ObservationArrays {
  std::span<std::int32_t> things;       // rows × kThingColumns
  std::span<std::int32_t> held;         // kHeldRows × kHeldColumns
  std::span<std::int32_t> last;         // kLastNumbers
  std::span<std::int32_t> counts;       // kCountNumbers
  std::span<std::uint8_t> instruction;  // UTF-8, padded with zeros; what does not fit is cut off
};

/// An action as numbers: of Gymnasium's action space.
struct NumberedAction {
  std::int64_t action = 0;      // in the list of names
  std::int64_t argument = 0;    // 0: none; else a row of `things` + 1
  std::array<double, 4> box{};  // x0, y0, x1, y1 as parts of the picture, 0 to 1; used where actions name boxes
};

/// Writes observations of one environment as arrays of fixed sizes, and reads actions that are numbers. A thing keeps
/// its row for the whole episode: first the rooms, furniture and movable objects that are known at the start, then
/// others in the order in which they came into view, those of one view by id. What finds no free row is left out.
class ArrayForm {
 public:
  ArrayForm(const Vocabulary& vocabulary, const std::vector<std::string>& actions, std::size_t rows)
      : vocabulary_(&vocabulary), actions_(&actions), rows_(rows) {}

  /// Begins an episode.
  void begin(const Observation& first);
  /// Gives rows to what is new in view. Call it for each observation.
  void see(const Observation& observation);
  void write(const Observation& observation, const ObservationArrays& arrays) const;

  /// What the numbers say. Numbers out of range and empty rows become names that no home has, which are failed steps.
  Command command_of(const NumberedAction& action, const ModeRules& rules, const Observation& observation) const;
  /// The id in each row that is in use.
  const std::vector<std::string>& ids() const { return ids_; }
  /// Whether all that the agent was told of found a row.
  bool complete() const { return complete_; }

 private:
  struct Row {
    std::int32_t kind = 0, category = 0;
  };
  void add(const NamedEntity& thing, std::int32_t kind);
  std::optional<std::size_t> row_of(std::string_view id) const;

  const Vocabulary* vocabulary_;
  const std::vector<std::string>* actions_;
  std::size_t rows_;
  std::vector<std::string> ids_;
  std::vector<Row> known_;
  std::unordered_map<std::string, std::size_t> row_by_id_;  // never iterated
  bool complete_ = true;
};

}  // namespace unietp::python
