#pragma once

#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

namespace unietp {

inline constexpr std::size_t kLongestComplaint = 200;  // bytes of a server's message that are shown

/// The JSON of a text that came from outside; discarded when it is none or nested over 64 deep.
nlohmann::json foreign_json(std::string_view text);

/// The string at a JSON pointer; empty when there is none.
std::string text_at(const nlohmann::json& json, const char* pointer);

}  // namespace unietp
