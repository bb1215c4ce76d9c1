#include "evaluation/prompt_slots.h"

#include <algorithm>
#include <array>

#include <nlohmann/json.hpp>

#include "core/text.h"
#include "environment/agent_text.h"
#include "environment/answer.h"
#include "environment/picture_text.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

const Observation& seen(const PromptContext& context) { return context.environment->observe(); }
const Settings& settings(const PromptContext& context) { return context.environment->settings(); }
const Profile& profile(const PromptContext& context) { return *context.environment->task()->data.profile; }

std::string system_slot(const PromptContext& context) { return context.environment->prompt(context.talk->thinking); }
std::string actions_slot(const PromptContext& context) {
  return action_space_text(settings(context).rules, profile(context));
}
std::string naming_slot(const PromptContext& context) { return naming_text(settings(context), profile(context)); }
std::string home_slot(const PromptContext& context) {
  return home_text(context.environment->task()->start, settings(context));
}
std::string max_steps_slot(const PromptContext& context) {
  return std::to_string(settings(context).rules.limits.steps);
}
std::string max_failures_slot(const PromptContext& context) {
  return std::to_string(settings(context).rules.limits.failures);
}
std::string steps_left_slot(const PromptContext& context) { return std::to_string(seen(context).steps_left); }
std::string instruction_slot(const PromptContext& context) { return seen(context).instruction; }

/// In a chat of several turns the first one tells the task.
std::string task_slot(const PromptContext& context) {
  return context.talk->multi && !context.past->empty() ? "" : task_text(seen(context).instruction);
}

/// The steps that are told again.
std::vector<const PastStep*> repeated_steps(const PromptContext& context) {
  std::vector<const PastStep*> steps;
  const std::size_t all = context.past->size();
  const std::size_t most = context.talk->history < 0 ? all : static_cast<std::size_t>(context.talk->history);
  for (std::size_t i = all - std::min(all, most); i < all; ++i) steps.push_back(&(*context.past)[i]);
  return steps;
}

/// Its own words on one line.
std::string own_words(const std::string& reply) {
  std::string line = reply;
  std::replace_if(
      line.begin(), line.end(), [](char c) { return static_cast<unsigned char>(c) < ' '; }, ' ');
  return std::string(trim(line));
}

/// Each action with `line_of`, or each reply where nothing is told of actions.
template <class LineOf>
std::vector<std::string> history_lines(const PromptContext& context, const LineOf& line_of) {
  std::vector<std::string> lines;
  for (const PastStep* step : repeated_steps(context)) {
    const bool has_outcomes = !step->results.empty() && step->results.front().success.has_value();
    if (!has_outcomes) lines.push_back(own_words(step->reply));
    for (const ActionReport& one : step->results) {
      if (has_outcomes) lines.push_back(line_of(one));
    }
  }
  return lines;
}

std::string history_slot(const PromptContext& context) {
  if (context.talk->multi) return "";
  const auto lines = history_lines(
      context, [](const ActionReport& one) { return history_text(one.action, *one.success, one.feedback); });
  return actions_text(lines, repeated_steps(context).size() < context.past->size());
}

std::string outcome_slot(const PromptContext& context) {
  const bool in_history = !context.talk->multi && context.talk->history != 0;
  return context.past->empty() || in_history ? "" : results_text(seen(context).results);
}

std::string pictures_slot(const PromptContext& context) {
  if (context.talk->multi || context.pictures < 2) return "";
  return "The last " + std::to_string(context.pictures) + " pictures of your camera, the present one last.";
}
std::string view_slot(const PromptContext& context) { return view_text(seen(context), settings(context)); }
std::string description_slot(const PromptContext& context) {
  return context.talk->described ? picture_text(*context.environment) : "";
}

// As the released runner tells them.

std::string release_actions_slot(const PromptContext& context) {
  std::string text;
  for (const auto list : {all_actions(), extension_actions()}) {
    for (const ActionInfo& action : list) {
      if (!profile(context).offers(action.type) || !offers(action, settings(context).rules)) continue;
      text += "- " + release_action_name(action.name);
      if (action.argument != ActionArgument::None) text += " (" + std::string(name_of(action.argument)) + ")";
      text += ": " + std::string(action.effect) + ".\n";
    }
  }
  return text;
}
std::string ids_of(std::initializer_list<const std::vector<NamedEntity>*> lists) {
  Json ids = Json::array();
  for (const auto* list : lists) {
    for (const NamedEntity& thing : *list) ids.push_back(thing.id);
  }
  return ids.dump();
}
std::string release_rooms_slot(const PromptContext& context) { return ids_of({&seen(context).home->rooms}); }
std::string release_objects_slot(const PromptContext& context) {
  return ids_of({&seen(context).home->furniture, &seen(context).home->movables});
}
std::string release_view_slot(const PromptContext& context) {
  const Observation& now = seen(context);
  if (!now.boxes) return "see the picture";
  Json list = Json::array();
  for (const ObservedObject& object : *now.boxes)
    list.push_back(
        {{"object_id", object.id},
         {"bbox_xyxy", box_in_form(object.box, settings(context).box_form, now.image_width, now.image_height)}});
  return list.dump();
}
std::string release_history_slot(const PromptContext& context) {
  const auto lines = history_lines(context, [](const ActionReport& one) {
    const std::size_t name_end = std::min(one.action.find('('), one.action.size());
    return release_action_name(std::string_view(one.action).substr(0, name_end)) + one.action.substr(name_end) +
           ". Action success: " + (*one.success ? "true" : "false") +
           (one.feedback.empty() ? "" : ". Feedback: " + one.feedback);
  });
  if (lines.empty()) return "none";
  std::string text;
  for (std::size_t i = 0; i < lines.size(); ++i) text += std::to_string(i + 1) + ". " + lines[i] + "\n";
  return text;
}

struct SlotRow {
  PromptSlot slot;
  std::string (*text)(const PromptContext&);
};
constexpr std::array kSlots{
    SlotRow{{"system", "the whole of what an agent is told before the episode, as in the SFT export"}, &system_slot},
    SlotRow{{"actions", "the actions that the mode offers, one a line, with what they need"}, &actions_slot},
    SlotRow{{"naming", "how objects and rooms are named, and where one may go at once"}, &naming_slot},
    SlotRow{{"home", "rooms, furniture and small things, as far as the mode tells them"}, &home_slot},
    SlotRow{{"max_steps", "the most actions"}, &max_steps_slot},
    SlotRow{{"max_failures", "the most failed actions"}, &max_failures_slot},
    SlotRow{{"steps_left", "actions that are left"}, &steps_left_slot},
    SlotRow{{"instruction", "the instruction, unchanged"}, &instruction_slot},
    SlotRow{{"task", "`Task: …`; in a chat of several turns only at the first step"}, &task_slot},
    SlotRow{{"history", "the actions so far with what became of them; empty in a chat of several turns"},
            &history_slot},
    SlotRow{{"outcome", "what became of the last action, where the history does not say it"}, &outcome_slot},
    SlotRow{{"pictures", "a note that several pictures are sent; empty for one or none"}, &pictures_slot},
    SlotRow{
        {"view",
         "where the agent stands, with a floor plan; ids and boxes of the objects in view, where the mode tells them"},
        &view_slot},
    SlotRow{{"description", "what the picture shows, in words, for models that cannot see; else empty"},
            &description_slot},
    SlotRow{{"release_actions", "the actions by the names of the released runner"}, &release_actions_slot},
    SlotRow{{"release_rooms", "the ids of the rooms as a JSON list"}, &release_rooms_slot},
    SlotRow{{"release_objects", "the ids of furniture and small things as a JSON list"}, &release_objects_slot},
    SlotRow{{"release_view", "the objects in view as JSON, with boxes"}, &release_view_slot},
    SlotRow{{"release_history", "the actions so far with `Action success: …` and `Feedback: …`"},
            &release_history_slot}};

std::string slot_text(const std::string& name, const PromptContext& context) {
  const auto row =
      std::find_if(kSlots.begin(), kSlots.end(), [&](const SlotRow& one) { return one.slot.name == name; });
  std::string text = row == kSlots.end() ? "" : row->text(context);
  while (text.ends_with('\n')) text.pop_back();
  return text;
}

}  // namespace

std::vector<PromptSlot> prompt_slots() {
  std::vector<PromptSlot> slots;
  for (const SlotRow& row : kSlots) slots.push_back(row.slot);
  return slots;
}

std::vector<std::string> prompt_slot_names() {
  std::vector<std::string> names;
  for (const SlotRow& row : kSlots) names.emplace_back(row.slot.name);
  return names;
}

std::string filled(const std::vector<PromptLine>& lines, const PromptContext& context) {
  std::string text;
  for (const PromptLine& line : lines) {
    std::string one, only_slots;
    bool has_slot = false;
    for (const PromptPiece& piece : line) {
      const std::string value = piece.slot.empty() ? "" : slot_text(piece.slot, context);
      has_slot = has_slot || !piece.slot.empty();
      one += piece.text + value;
    }
    if (has_slot && trim(one).empty()) continue;
    text += one + "\n";
  }
  while (text.ends_with('\n')) text.pop_back();
  return text;
}

}  // namespace unietp
