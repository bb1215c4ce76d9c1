#include "environment/answer.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <utility>

#include <nlohmann/json.hpp>

#include "core/limits.h"
#include "core/plain_name.h"
#include "core/text.h"
#include "scene/json_parse.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

Error unreadable(std::string expected) { return {Error::Kind::Schema, "answer", {}, std::move(expected)}; }

/// Names of the released runner that do not become ours by putting `_` for blanks.
constexpr std::array<std::pair<std::string_view, std::string_view>, 5> kReleaseNames{{
    {"done", "stop"},
    {"turn_base_to_looking_direction", "turn_base_to_look"},
    {"reset_head_direction", "reset_head"},
    {"turn_to_point", "turn_to"},
    {"place_to_point", "place_on"},
}};

/// "Heat the object in hand with" and "heat_with" are one action.
std::string action_name(std::string_view text) {
  std::string name = lower(trim(text));
  std::replace(name.begin(), name.end(), ' ', '_');
  std::replace(name.begin(), name.end(), '-', '_');
  for (const auto& [theirs, ours] : kReleaseNames) {
    if (name == theirs) return std::string(ours);
  }
  return replace_all(std::move(name), "_the_object_in_hand_with", "_with");
}

/// Reads the values of one answer and keeps what was expected where one is wrong.
class AnswerReader {
 public:
  explicit AnswerReader(const AnswerFrame& frame) : frame_(frame) {}

  Result<Answer> read(const Json& json) {
    Answer answer;
    const Json* actions = &json;
    if (json.is_object()) {
      if (const auto reasoning = json.find("reasoning"); reasoning != json.end() && reasoning->is_string())
        answer.reasoning = reasoning->get<std::string>();
      if (const auto list = json.find("actions"); list != json.end()) actions = &*list;
    }
    if (actions->is_object()) {
      answer.actions.push_back(action(*actions));
    } else if (actions->is_array() && !actions->empty() && actions->size() <= limits::kAgentActions) {
      for (const Json& one : *actions) answer.actions.push_back(action(one));
    } else {
      expect("expected 1 to " + std::to_string(limits::kAgentActions) + " actions in a list");
    }
    if (!expected_.empty()) return unreadable(expected_);
    return answer;
  }

 private:
  void expect(std::string what) {
    if (expected_.empty()) expected_ = std::move(what);
  }

  AnsweredAction action(const Json& json) {
    AnsweredAction answered;
    const Json* name = field(json, {"action", "action_name"});
    if (name == nullptr || !name->is_string() || !is_label(name->get_ref<const std::string&>())) {
      expect(std::string(kExpectedAction));
      return answered;
    }
    answered.command.action = action_name(name->get_ref<const std::string&>());
    if (answered.command.action.empty()) expect(std::string(kExpectedAction));  // of blanks
    const Json* args = field(json, {"args", "arguments"});
    if (args == nullptr || args->is_null()) return answered;
    if (args->is_array() && !is_numbers(*args, 4) && !is_numbers(*args, 2)) {
      if (args->size() > 1) expect("expected at most one argument");
      for (const Json& one : *args) argument(answered, one);
    } else if (args->is_object() && field(*args, {"bbox", "point"}) == nullptr) {
      named_arguments(answered, *args);
    } else {
      argument(answered, *args);
    }
    return answered;
  }

  static const Json* field(const Json& json, std::initializer_list<const char*> names) {
    if (!json.is_object()) return nullptr;
    for (const char* name : names) {
      if (const auto found = json.find(name); found != json.end()) return &*found;
    }
    return nullptr;
  }

  static bool is_numbers(const Json& json, std::size_t count) {
    return json.is_array() && json.size() == count &&
           std::all_of(json.begin(), json.end(), [](const Json& one) { return one.is_number(); });
  }

  void argument(AnsweredAction& answered, const Json& json) {
    if (json.is_string()) return id(answered, json);
    if (is_numbers(json, 4)) return box(answered, json);
    if (is_numbers(json, 2)) return point(answered, json);
    if (const Json* numbers = field(json, {"bbox"})) return box(answered, *numbers);
    if (const Json* numbers = field(json, {"point"})) return point(answered, *numbers);
    expect("expected an id, {\"bbox\": [four numbers]} or {\"point\": [two numbers]} as argument");
  }

  /// {"object_id": …} and the like, of which one has a value.
  void named_arguments(AnsweredAction& answered, const Json& json) {
    int given = 0;
    for (const auto& [name, value] : json.items()) {
      if (value.is_null()) continue;
      if (++given > 1) return expect("expected at most one argument");
      if (name == "object_id" || name == "room_id" || name == "tool_id") {
        id(answered, value);
      } else if (name == "pixel") {
        point(answered, value);
      } else if (name == "object_bbox") {
        const Json* numbers = field(value, {"bbox"});
        box(answered, numbers == nullptr ? value : *numbers);
      } else {
        expect("expected object_id, room_id, tool_id, pixel or object_bbox in \"args\"");
      }
    }
  }

  void id(AnsweredAction& answered, const Json& json) {
    if (!json.is_string() || !is_label(json.get_ref<const std::string&>()))
      return expect("expected an id of 1 to " + std::to_string(limits::kLabelBytes) + " bytes");
    answered.command.args.push_back({json.get<std::string>(), std::nullopt});
  }

  /// In pixels; NaN and what no picture has become a place outside of it.
  int pixel(const Json& json, int size) const {
    const double number = json.get<double>();
    const double pixels = frame_.form == BoxForm::Pixels ? number
                          : frame_.form == BoxForm::Unit ? number * size
                                                         : number * size / 1000;
    constexpr double kFar = 1e6;
    return std::isfinite(pixels) ? static_cast<int>(std::round(std::clamp(pixels, -kFar, kFar)))
                                 : -static_cast<int>(kFar);
  }
  bool y_first() const { return frame_.form == BoxForm::ThousandYFirst; }

  void box(AnsweredAction& answered, const Json& json) {
    if (!is_numbers(json, 4)) return expect("expected four numbers in \"bbox\"");
    const std::size_t x = y_first() ? 1 : 0, y = y_first() ? 0 : 1;
    const PixelBox box{pixel(json[x], frame_.width), pixel(json[y], frame_.height), pixel(json[x + 2], frame_.width),
                       pixel(json[y + 2], frame_.height)};
    answered.command.args.push_back({"", box});
  }

  void point(AnsweredAction& answered, const Json& json) {
    if (!is_numbers(json, 2)) return expect("expected two numbers in \"point\"");
    const std::size_t x = y_first() ? 1 : 0;
    answered.point = {pixel(json[x], frame_.width), pixel(json[1 - x], frame_.height)};
  }

  const AnswerFrame& frame_;
  std::string expected_;
};

bool may_be_answer(const Json& json) {
  return json.is_object() || (json.is_array() && !json.empty() &&
                              std::all_of(json.begin(), json.end(), [](const Json& one) { return one.is_object(); }));
}

/// Where the bracket that opens at a place closes, or npos.
std::size_t closing(std::string_view text, std::size_t open) {
  int depth = 0;
  bool quoted = false;
  for (std::size_t i = open; i < text.size(); ++i) {
    const char c = text[i];
    if (quoted) {
      if (c == '\\') ++i;
      if (c == '"') quoted = false;
      continue;
    }
    if (c == '"') quoted = true;
    if (c == '{' || c == '[') ++depth;
    if ((c == '}' || c == ']') && --depth == 0) return i;
  }
  return std::string_view::npos;
}

/// The JSON in a text that may be an answer; nullopt when there is none, or several.
struct FoundJson {
  std::optional<Json> json;
  int count = 0;
};
FoundJson json_within(std::string_view text) {
  constexpr int kTries = 32;  // brackets that may open an answer; each may cost the length of the text
  FoundJson found;
  int tries = 0;
  for (std::size_t at = 0; at < text.size() && tries < kTries; ++at) {
    if (text[at] != '{' && text[at] != '[') continue;
    ++tries;
    const std::size_t end = closing(text, at);
    if (end == std::string_view::npos) continue;
    auto json = parse_json("answer", text.substr(at, end - at + 1));
    if (!json) continue;
    at = end;
    if (!may_be_answer(*json)) continue;
    if (++found.count == 1) found.json = std::move(*json);
  }
  return found;
}

/// What stands between the fences of a text, when it has one block.
std::string_view fenced(std::string_view text) {
  constexpr std::string_view kFence = "```";
  const auto begin = text.find(kFence);
  if (begin == std::string_view::npos) return {};
  const auto end = text.find(kFence, begin + kFence.size());
  if (end == std::string_view::npos || text.find(kFence, end + kFence.size()) != std::string_view::npos) return {};
  return text.substr(begin + kFence.size(), end - begin - kFence.size());
}

/// pick_up(mug_1)
std::optional<Answer> called(std::string_view text) {
  const auto is_ascii = [](char c) { return static_cast<unsigned char>(c) < 0x80; };
  if (!std::all_of(text.begin(), text.end(), is_ascii)) return std::nullopt;  // JSON alone is known to be UTF-8
  const auto is_name = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_' || c == ' '; };
  const auto open = text.find('(');
  const std::string_view name = trim(text.substr(0, open));
  if (name.empty() || name.size() > limits::kLabelBytes || !std::all_of(name.begin(), name.end(), is_name))
    return std::nullopt;
  const auto type = action_named(action_name(name));
  if (!type) return std::nullopt;
  AnsweredAction answered{{std::string(info(*type).name), {}}, {}};
  if (open != std::string_view::npos) {
    if (text.back() != ')') return std::nullopt;
    const std::string_view inside = trim(text.substr(open + 1, text.size() - open - 2));
    if (!inside.empty()) {
      if (!is_label(inside)) return std::nullopt;
      answered.command.args.push_back({std::string(inside), std::nullopt});
    }
  }
  return Answer{{std::move(answered)}, ""};
}

/// pick_up([10, 20, 30, 40]): the box as JSON.
std::optional<Json> call_with_box(std::string_view text) {
  const auto open = text.find("([");
  if (open == std::string_view::npos || text.back() != ')') return std::nullopt;
  const auto name = action_named(action_name(text.substr(0, open)));
  auto numbers = parse_json("answer", text.substr(open + 1, text.size() - open - 2));
  if (!name || !numbers) return std::nullopt;
  return Json{{"action", info(*name).name}, {"args", std::move(*numbers)}};
}

}  // namespace

std::string release_action_name(std::string_view ours) {
  std::string name(ours);
  for (const auto& [theirs, known] : kReleaseNames) {
    if (known == ours && !theirs.ends_with("_point")) name = theirs;
  }
  if (name.ends_with("_with")) name = name.substr(0, name.size() - 5) + "_the_object_in_hand_with";
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

Result<Answer> parse_answer(std::string_view text, const AnswerFrame& frame) {
  if (text.size() > limits::kAgentAnswerBytes)
    return unreadable("expected at most " + std::to_string(limits::kAgentAnswerBytes) + " bytes");
  text = trim(text);
  if (text.empty()) return unreadable(std::string(kExpectedJson));
  if (const auto json = call_with_box(text)) return AnswerReader(frame).read(*json);
  if (auto call = called(text)) return std::move(*call);
  if (const auto whole = parse_json("answer", text); whole && may_be_answer(*whole))
    return AnswerReader(frame).read(*whole);
  FoundJson found = json_within(fenced(text));
  if (found.count != 1) found = json_within(text);
  if (found.count > 1) return unreadable(std::string(kExpectedOneObject));
  if (found.count == 0) return unreadable(std::string(kExpectedJson));
  return AnswerReader(frame).read(*found.json);
}

}  // namespace unietp
