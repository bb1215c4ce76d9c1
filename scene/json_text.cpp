#include "scene/json_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include <nlohmann/json.hpp>

namespace unietp {

void JsonText::key(std::string_view name) {
  separate();
  text_ += '"';
  text_ += name;
  text_ += "\":";
  first_ = true;
}

void JsonText::value(std::string_view text) {
  separate();
  const bool plain =
      std::all_of(text.begin(), text.end(), [](char c) { return c >= ' ' && c <= '~' && c != '"' && c != '\\'; });
  if (plain) {
    text_ += '"';
    text_ += text;
    text_ += '"';
  } else {
    using Json = nlohmann::json;
    text_ += Json(std::string(text)).dump(-1, ' ', false, Json::error_handler_t::replace);
  }
}

void JsonText::value(double number) {
  separate();
  if (!std::isfinite(number)) {
    text_ += "null";
    return;
  }
  std::array<char, 32> buffer{};
  const char* end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number).ptr;
  const std::string_view digits(buffer.data(), static_cast<std::size_t>(end - buffer.data()));
  text_ += digits;
  if (digits.find_first_of(".e") == std::string_view::npos) text_ += ".0";
}

void JsonText::value(bool truth) {
  separate();
  text_ += truth ? "true" : "false";
}

void JsonText::value(int number) {
  separate();
  text_ += std::to_string(number);
}

void JsonText::tree(const nlohmann::ordered_json& json) {
  if (json.is_object()) {
    open_object();
    for (const auto& [name, member] : json.items()) {
      value(name);
      text_ += ':';
      first_ = true;
      tree(member);
    }
    close_object();
  } else if (json.is_array()) {
    open_list();
    for (const auto& item : json) tree(item);
    close_list();
  } else if (json.is_number_float()) {
    value(json.get<double>());
  } else if (json.is_string()) {
    value(json.get_ref<const std::string&>());
  } else {
    raw(json.dump());
  }
}

void JsonText::raw(std::string_view json) {
  separate();
  text_ += json;
}

}  // namespace unietp
