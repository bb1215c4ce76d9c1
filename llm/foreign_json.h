#pragma once

#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

namespace unietp {

inline constexpr std::size_t kLongestErrorMessage = 200;  // bytes of a server's message that are shown

/// Parses JSON from a server; discarded when it is invalid or nested over 64 deep.
nlohmann::json foreign_json(std::string_view text);

/// The string at a JSON pointer; empty when there is none.
std::string text_at(const nlohmann::json& json, const char* pointer);

}  // namespace unietp
