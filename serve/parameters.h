#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

#include "core/error.h"
#include "scene/json_reader.h"

namespace unietp {

/// How errors name what a client sent.
inline constexpr std::string_view kCallName = "call";
/// An error's message without that name: "/seed: expected a number, not null".
std::string in_call(const Error& error);

/// The parameters of a call. Each function notes an error for a value of another type and then returns nothing.
class Parameters {
 public:
  /// `json` is an object and outlives this.
  explicit Parameters(const nlohmann::ordered_json& json);

  bool flag(std::string_view name);  // false when it is missing
  std::optional<std::string> text(std::string_view name);
  std::optional<std::uint64_t> whole(std::string_view name);  // 0 to limits::kSeed
  const nlohmann::ordered_json* any(std::string_view name);   // nullptr when it is missing

  /// After all were asked for: what is wrong, such as a parameter that nobody asked for; nullopt: nothing.
  std::optional<std::string> problem();

 private:
  JsonReader reader_;
  JsonAt at_;
  JsonFields fields_;
};

}  // namespace unietp
