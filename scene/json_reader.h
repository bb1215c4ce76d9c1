#pragma once

#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "core/error.h"
#include "scene/geometry.h"

namespace unietp {

/// A JSON value with its path in the file; the path is only made into text for an error.
struct JsonAt {
  const nlohmann::ordered_json& json;
  const JsonAt* parent = nullptr;
  std::string_view key = {};  // of an object's field
  std::size_t index = 0;      // of an array's item

  /// The way as a JSON pointer: "/nodes/3/pose"; "" for the whole text.
  std::string pointer() const;
};

/// Reads values strictly and keeps the first error. After an error, calls stay safe but their results mean nothing.
class JsonReader {
 public:
  explicit JsonReader(std::string_view where) : where_(where) {}

  /// The first error, or nullopt as long as all was well.
  const std::optional<Error>& error() const { return error_; }
  /// Notes a Schema error at a place, unless there is one already.
  void fail(const JsonAt& at, std::string message);
  void fail(const std::string& pointer, std::string message);

  /// Each of these notes an error for a value of another type and then returns a default. `number` and `positive` take
  /// finite numbers only; `positive` must be greater than 0.
  double number(const JsonAt& at);
  double positive(const JsonAt& at);
  bool boolean(const JsonAt& at);
  std::string text(const JsonAt& at);  // not empty
  /// An id that may name a file: core/plain_name.h.
  std::string plain_name(const JsonAt& at);
  /// A text of at most limits::kTextBytes without control characters, so that it stays on its line of a file.
  std::string line(const JsonAt& at);
  /// An id or a word of a scene: a line of at most limits::kLabelBytes.
  std::string label(const JsonAt& at);
  Vec2 vec2(const JsonAt& at);      // [x, y]
  Vec3 vec3(const JsonAt& at);      // [x, y, z]
  Quat rotation(const JsonAt& at);  // [w, x, y, z], of unit length within 1e-6
  /// Length of the array; 0 and an error when it is none.
  std::size_t items(const JsonAt& at);
  /// The same, with an error for more than `most`.
  std::size_t items(const JsonAt& at, std::size_t most);
  /// A vector in meters, each of whose numbers is within [-most, most].
  Vec2 vec2_within(const JsonAt& at, double most);
  Vec3 vec3_within(const JsonAt& at, double most);
  /// An item of an array; `index` must be less than items(array), and `array` outlive the result.
  JsonAt item(const JsonAt& array, std::size_t index);
  /// A list of names that are not empty.
  std::vector<std::string> texts(const JsonAt& at);
  /// "unknown archetype "vesel", did you mean "vessel"; accepted are …"
  void unknown_name(const JsonAt& at, std::string_view kind, const std::vector<std::string>& accepted);

 private:
  void keep_within(const JsonAt& at, double farthest, double most);
  bool numbers(const JsonAt& at, std::size_t count, std::string_view shape, double* values);

  std::string_view where_;
  std::optional<Error> error_;
};

/// The fields of one object. Every field that the object has must be asked for; `finish` refuses the others.
class JsonFields {
 public:
  JsonFields(JsonReader& reader, const JsonAt& at);

  /// The field, or nothing and an error when it is missing.
  std::optional<JsonAt> required(std::string_view name);
  /// The field, or nothing when the object lacks it.
  std::optional<JsonAt> optional(std::string_view name);
  /// Notes an error when the object has a field that was not asked for.
  void finish();

 private:
  JsonReader& reader_;
  const JsonAt& at_;
  std::size_t next_ = 0;                 // where the field after the last one found would stand
  std::vector<std::string_view> asked_;  // in order
  std::size_t found_ = 0;
};

}  // namespace unietp
