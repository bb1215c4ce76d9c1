#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scene/action.h"

namespace unietp {

/// The action of a step and its result, without the view and the changes.
struct ActionRow {
  Mode mode = Mode::M1;
  std::string action, arguments;  // arguments: as text, separated by ", "
  bool success = false;
  std::string failure;
  bool operator==(const ActionRow&) const = default;
};

/// The fields of a task in dataset.sqlite and in the manifest's counts, without its traits. `forms`: with blanks
/// between them.
struct TaskRow {
  std::string id, split, simulator, template_name, scene, layout, goal, instruction, style, writer, sense, forms;
  std::vector<std::pair<std::string, std::string>> bindings;  // placeholder, category
  std::vector<ActionRow> actions;                             // of its demonstrations, one mode after the other
  bool operator==(const TaskRow&) const = default;
};

/// The steps of a row's demonstration in a mode, and how many of them failed.
std::pair<int, int> steps_and_failures(const TaskRow& row, Mode mode);
/// The modes of its demonstrations, in their order.
std::vector<Mode> modes_of(const TaskRow& row);

/// Lists as text with one entry per line and tabs between the fields, and their readers, which return nullopt for other
/// texts. Names of placeholders, categories, objects and actions contain no tabs and no line feeds.
std::string bindings_text(const TaskRow& row);
std::optional<std::vector<std::pair<std::string, std::string>>> bindings_from(std::string_view text);
std::string actions_text(const TaskRow& row);
std::optional<std::vector<ActionRow>> actions_from(std::string_view text);

}  // namespace unietp
