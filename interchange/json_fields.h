#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "core/result.h"
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

/// The values of a text: one JSON value, or one a line (JSON Lines). Errors: Parse with line and column.
Result<std::vector<nlohmann::ordered_json>> read_json_values(std::string_view where, std::string_view text);

}  // namespace unietp
