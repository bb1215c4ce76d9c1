#include "dataset/task_row.h"

#include <algorithm>

#include "core/text.h"

namespace unietp {
namespace {

/// The fields of each line; nullopt when a line has another number of them, or the last one has no end.
std::optional<std::vector<std::vector<std::string>>> fields_of(std::string_view text, std::size_t count) {
  std::vector<std::vector<std::string>> lines;
  if (text.empty()) return lines;
  if (text.back() != '\n') return std::nullopt;
  text.remove_suffix(1);
  for (const auto& line : split(text, '\n')) {
    lines.push_back(split(line, '\t'));
    if (lines.back().size() != count) return std::nullopt;
  }
  return lines;
}

}  // namespace

std::pair<int, int> steps_and_failures(const TaskRow& row, Mode mode) {
  std::pair<int, int> counts{0, 0};
  for (const ActionRow& action : row.actions) {
    if (action.mode != mode) continue;
    ++counts.first;
    counts.second += action.success ? 0 : 1;
  }
  return counts;
}

std::vector<Mode> modes_of(const TaskRow& row) {
  std::vector<Mode> modes;
  for (const ActionRow& action : row.actions) {
    if (std::find(modes.begin(), modes.end(), action.mode) == modes.end()) modes.push_back(action.mode);
  }
  return modes;
}

std::string bindings_text(const TaskRow& row) {
  std::string text;
  for (const auto& [placeholder, category] : row.bindings)
    text.append(placeholder).append("\t").append(category) += '\n';
  return text;
}

std::optional<std::vector<std::pair<std::string, std::string>>> bindings_from(std::string_view text) {
  auto lines = fields_of(text, 2);
  if (!lines) return std::nullopt;
  std::vector<std::pair<std::string, std::string>> bindings;
  for (auto& fields : *lines) bindings.emplace_back(std::move(fields[0]), std::move(fields[1]));
  return bindings;
}

std::string actions_text(const TaskRow& row) {
  std::string text;
  for (const ActionRow& action : row.actions) {
    text.append(name_of(action.mode)).append("\t").append(action.action).append("\t").append(action.arguments);
    text.append(action.success ? "\t1\t" : "\t0\t").append(action.failure) += '\n';
  }
  return text;
}

std::optional<std::vector<ActionRow>> actions_from(std::string_view text) {
  auto lines = fields_of(text, 5);
  if (!lines) return std::nullopt;
  std::vector<ActionRow> actions;
  for (auto& fields : *lines) {
    const auto mode = mode_named(fields[0]);
    if (!mode || (fields[3] != "0" && fields[3] != "1")) return std::nullopt;
    actions.push_back({*mode, std::move(fields[1]), std::move(fields[2]), fields[3] == "1", std::move(fields[4])});
  }
  return actions;
}

}  // namespace unietp
