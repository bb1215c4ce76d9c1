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

/// A JSON value and the way to it; the way is spelt out only for an error.
struct JsonAt {
  const nlohmann::ordered_json& json;
  const JsonAt* parent = nullptr;
  std::string_view key = {};  // of an object's field
  std::size_t index = 0;      // of an array's item

  std::string pointer() const;
};

/// Reads values strictly and remembers the first error; after one, readings are of no use but still safe.
class JsonReader {
 public:
  explicit JsonReader(std::string_view where) : where_(where) {}

  const std::optional<Error>& error() const { return error_; }
  void fail(const JsonAt& at, std::string message);
  void fail(const std::string& pointer, std::string message);

  double number(const JsonAt& at);
  double positive(const JsonAt& at);
  bool boolean(const JsonAt& at);
  std::string text(const JsonAt& at);  // not empty
  /// An id that may name a file: core/plain_name.h.
  std::string plain_name(const JsonAt& at);
  /// A text without control characters, so that it stays on its line of a file or terminal.
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
  /// A vector in metres, each of whose numbers is within [-most, most].
  Vec2 vec2_within(const JsonAt& at, double most);
  Vec3 vec3_within(const JsonAt& at, double most);
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
  std::optional<JsonAt> optional(std::string_view name);
  void finish();

 private:
  JsonReader& reader_;
  const JsonAt& at_;
  std::size_t next_ = 0;                 // where the field after the last one found would stand
  std::vector<std::string_view> asked_;  // in order
  std::size_t found_ = 0;
};

}  // namespace unietp
