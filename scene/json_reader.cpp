#include "scene/json_reader.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <nlohmann/json.hpp>

#include "core/in_quotes.h"
#include "core/limits.h"
#include "core/plain_name.h"
#include "core/text.h"
#include "scene/json_parse.h"
#include "scene/json_pointer.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

std::string type_of(const Json& json) { return json.is_null() ? "null" : "a JSON " + std::string(json.type_name()); }

}  // namespace

std::string JsonAt::pointer() const {
  if (parent == nullptr) return {};
  return parent->pointer() + "/" + (key.empty() ? std::to_string(index) : pointer_token(key));
}

void JsonReader::fail(const JsonAt& at, std::string message) {
  if (!error_) fail(at.pointer(), std::move(message));
}

void JsonReader::fail(const std::string& pointer, std::string message) {
  if (!error_) error_ = Error{Error::Kind::Schema, at_pointer(where_, pointer), {}, std::move(message)};
}

double JsonReader::number(const JsonAt& at) {
  if (!at.json.is_number()) {
    fail(at, "expected a number, not " + type_of(at.json));
    return 0;
  }
  const double value = at.json.get<double>();
  if (!std::isfinite(value)) fail(at, "expected a finite number");
  return value;
}

double JsonReader::positive(const JsonAt& at) {
  const double value = number(at);
  if (!error_ && !(value > 0)) fail(at, "expected a number above 0, not " + number_text(value));
  return value;
}

bool JsonReader::boolean(const JsonAt& at) {
  const auto* value = at.json.get_ptr<const Json::boolean_t*>();
  if (value == nullptr) fail(at, "expected true or false, not " + type_of(at.json));
  return value != nullptr && *value;
}

std::string JsonReader::text(const JsonAt& at) {
  const auto* value = at.json.get_ptr<const Json::string_t*>();
  if (value == nullptr) {
    fail(at, "expected a string, not " + type_of(at.json));
    return {};
  }
  if (value->empty()) fail(at, "expected a string that is not empty");
  return *value;
}

std::string JsonReader::plain_name(const JsonAt& at) {
  std::string value = text(at);
  if (!error_ && !is_plain_name(value)) fail(at, in_quotes(value) + " is no name; " + plain_name_expected());
  return value;
}

std::string JsonReader::line(const JsonAt& at) {
  std::string value = text(at);
  if (!error_ && !is_one_line(value))
    fail(at, in_quotes(value) + " has control characters; expected a text on one line");
  if (!error_ && value.size() > limits::kTextBytes)
    fail(at, "has " + std::to_string(value.size()) + " bytes; expected at most " + std::to_string(limits::kTextBytes));
  return value;
}

std::string JsonReader::label(const JsonAt& at) {
  std::string value = text(at);
  if (!error_ && !is_label(value)) fail(at, in_quotes(value) + " is no label; " + label_expected());
  return value;
}

bool JsonReader::numbers(const JsonAt& at, std::size_t count, std::string_view shape, double* values) {
  const auto* list = at.json.get_ptr<const Json::array_t*>();
  if (list == nullptr || list->size() != count) {
    fail(at, "expected " + std::string(shape) + ", not " +
                 (list == nullptr ? type_of(at.json) : std::to_string(list->size()) + " items"));
    return false;
  }
  for (std::size_t i = 0; i < count; ++i) values[i] = number(item(at, i));
  return !error_;
}

Vec2 JsonReader::vec2(const JsonAt& at) {
  Vec2 value = Vec2::Zero();
  numbers(at, 2, "[x, y]", value.data());
  return value;
}

Vec3 JsonReader::vec3(const JsonAt& at) {
  Vec3 value = Vec3::Zero();
  numbers(at, 3, "[x, y, z]", value.data());
  return value;
}

Quat JsonReader::rotation(const JsonAt& at) {
  double wxyz[4] = {1, 0, 0, 0};
  if (!numbers(at, 4, "[w, x, y, z]", wxyz)) return Quat::Identity();
  Quat value(wxyz[0], wxyz[1], wxyz[2], wxyz[3]);
  if (!(std::abs(value.norm() - 1) <= 1e-6)) {
    fail(at, "expected a quaternion of length 1, not " + number_text(value.norm()));
  }
  return value;
}

std::size_t JsonReader::items(const JsonAt& at) {
  const auto* list = at.json.get_ptr<const Json::array_t*>();
  if (list == nullptr) fail(at, "expected a list, not " + type_of(at.json));
  return list == nullptr ? 0 : list->size();
}

std::size_t JsonReader::items(const JsonAt& at, std::size_t most) {
  const std::size_t count = items(at);
  if (count <= most) return count;
  fail(at, "has " + std::to_string(count) + " items; expected at most " + std::to_string(most));
  return 0;
}

void JsonReader::keep_within(const JsonAt& at, double farthest, double most) {
  if (!error_ && !(farthest <= most))
    fail(at, "is " + number_text(farthest) + " m; expected at most " + number_text(most) + " m");
}

Vec2 JsonReader::vec2_within(const JsonAt& at, double most) {
  Vec2 value = vec2(at);
  keep_within(at, value.cwiseAbs().maxCoeff(), most);
  return value;
}

Vec3 JsonReader::vec3_within(const JsonAt& at, double most) {
  Vec3 value = vec3(at);
  keep_within(at, value.cwiseAbs().maxCoeff(), most);
  return value;
}

JsonAt JsonReader::item(const JsonAt& array, std::size_t index) {
  return JsonAt{(*array.json.get_ptr<const Json::array_t*>())[index], &array, {}, index};
}

std::vector<std::string> JsonReader::texts(const JsonAt& at) {
  std::vector<std::string> list(items(at));
  for (std::size_t i = 0; i < list.size() && !error_; ++i) list[i] = text(item(at, i));
  return list;
}

void JsonReader::unknown_name(const JsonAt& at, std::string_view kind, const std::vector<std::string>& accepted) {
  if (error_) return;
  const auto* name = at.json.get_ptr<const Json::string_t*>();
  if (name == nullptr) return fail(at, "expected a string, not " + type_of(at.json));
  const std::string near = name->size() <= 64 ? nearest_name(*name, accepted) : std::string();
  fail(at, "unknown " + std::string(kind) + " " + in_quotes(*name) +
               (near.empty() ? "" : ", did you mean " + in_quotes(near)) + "; accepted are " + join(accepted, ", "));
}

JsonFields::JsonFields(JsonReader& reader, const JsonAt& at) : reader_(reader), at_(at) {
  if (!at.json.is_object()) reader.fail(at, "expected an object, not " + type_of(at.json));
}

std::optional<JsonAt> JsonFields::optional(std::string_view name) {
  asked_.push_back(name);
  const auto* fields = at_.json.get_ptr<const Json::object_t*>();
  if (fields == nullptr) return std::nullopt;
  for (std::size_t step = 0; step < fields->size(); ++step) {
    const std::size_t place = (next_ + step) % fields->size();
    const auto& [key, value] = *(fields->begin() + static_cast<std::ptrdiff_t>(place));
    if (key != name) continue;
    next_ = place + 1;
    ++found_;
    return JsonAt{value, &at_, name, 0};
  }
  return std::nullopt;
}

std::optional<JsonAt> JsonFields::required(std::string_view name) {
  auto field = optional(name);
  if (!field) reader_.fail(at_, "the field " + in_quotes(name) + " is missing");
  return field;
}

void JsonFields::finish() {
  const auto* fields = at_.json.get_ptr<const Json::object_t*>();
  if (reader_.error() || fields == nullptr || found_ == fields->size()) return;
  for (const auto& [key, value] : *fields) {
    if (std::find(asked_.begin(), asked_.end(), key) != asked_.end()) continue;
    const std::vector<std::string> accepted(asked_.begin(), asked_.end());
    const std::string near = key.size() <= 64 ? nearest_name(key, accepted) : std::string();
    return reader_.fail(at_.pointer() + "/" + pointer_token(key),
                        "unknown field " + in_quotes(key) + (near.empty() ? "" : ", did you mean " + in_quotes(near)) +
                            "; accepted are " + join(accepted, ", "));
  }
}

}  // namespace unietp
