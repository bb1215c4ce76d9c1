#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scene/action.h"

namespace unietp {

/// What was done in a step, without what was seen and what changed.
struct ActionRow {
  Mode mode = Mode::M1;
  std::string action, arguments;  // arguments: as text, separated by ", "
  bool success = false;
  std::string failure;
  bool operator==(const ActionRow&) const = default;
};

/// What dataset.sqlite and the manifest's counts state of a task beside its traits.
struct TaskRow {
  std::string id, split, simulator, template_name, scene, layout, goal, instruction, style, writer;
  std::vector<std::pair<std::string, std::string>> bindings;  // placeholder, category
  std::vector<ActionRow> actions;                             // of its demonstrations, one mode after the other
  bool operator==(const TaskRow&) const = default;
};

/// The steps of a row's demonstration in a mode, and how many of them failed.
std::pair<int, int> steps_and_failures(const TaskRow& row, Mode mode);
/// The modes of its demonstrations, in their order.
std::vector<Mode> modes_of(const TaskRow& row);

/// Lists as text, an entry a line with tabs between its fields, and read back; nullopt for a text that is none. No name
/// of a placeholder, a category, an object or an action has a tab or a line feed.
std::string bindings_text(const TaskRow& row);
std::optional<std::vector<std::pair<std::string, std::string>>> bindings_from(std::string_view text);
std::string actions_text(const TaskRow& row);
std::optional<std::vector<ActionRow>> actions_from(std::string_view text);

}  // namespace unietp
