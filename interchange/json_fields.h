#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "core/result.h"
#include "interchange/source_scene.h"
#include "scene/json_reader.h"

namespace unietp {

/// The simulators' files hold far more than is read here, so unknown fields are passed over and `null` is as good as
/// absent; what is read must have its type.
class LooseFields {
 public:
  LooseFields(JsonReader& reader, const JsonAt& at) : reader_(&reader), at_(&at) {}
  /// nullopt when it is absent or null.
  std::optional<JsonAt> find(std::string_view name) const;
  /// An error when it is absent.
  std::optional<JsonAt> need(std::string_view name) const;

  std::string text(std::string_view name) const;  // "" when absent; may be empty
  double number(std::string_view name, double absent = 0) const;
  bool flag(std::string_view name) const;  // false when absent
  std::vector<std::string> texts(std::string_view name) const;

 private:
  JsonReader* reader_;
  const JsonAt* at_;
};

/// [x, y, z] or {"x": …, "y": …, "z": …}.
Vec3 vector_at(JsonReader& reader, const JsonAt& at);

/// Gives each value of a text to `take`: one JSON value, with the line 0, or one a line (JSON Lines), with its line
/// from
/// 1. One value is in memory at a time. Errors: Parse with line and column, and what `take` returns.
Result<Done> each_json_value(std::string_view where, std::string_view text,
                             const std::function<std::optional<Error>(const JsonAt& value, int line)>& take);

/// Fails at `home`, the last one read, when the homes of a file exceed limits::kHomesInFile or kObjectsInFile.
void keep_to_a_file(JsonReader& reader, const JsonAt& home, const std::vector<SourceScene>& scenes);

}  // namespace unietp
