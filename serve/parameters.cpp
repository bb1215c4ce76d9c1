#include "serve/parameters.h"

#include <nlohmann/json.hpp>

#include "record/record_fields.h"

namespace unietp {

std::string in_call(const Error& error) {
  std::string_view place = error.where;
  if (place.starts_with(kCallName)) place.remove_prefix(kCallName.size());
  if (place.starts_with('#')) place.remove_prefix(1);   // a JSON pointer follows
  if (place.starts_with(": ")) place.remove_prefix(2);  // the name of a setting
  return (place.empty() ? "" : std::string(place) + ": ") + error.message;
}

Parameters::Parameters(const nlohmann::ordered_json& json) : reader_(kCallName), at_{json}, fields_(reader_, at_) {}

bool Parameters::flag(std::string_view name) {
  const auto at = fields_.optional(name);
  return at && reader_.boolean(*at);
}

std::optional<std::string> Parameters::text(std::string_view name) {
  const auto at = fields_.optional(name);
  return at ? std::optional(reader_.line(*at)) : std::nullopt;
}

std::optional<std::uint64_t> Parameters::whole(std::string_view name) {
  const auto at = fields_.optional(name);
  return at ? std::optional(read_seed(reader_, *at)) : std::nullopt;
}

const nlohmann::ordered_json* Parameters::any(std::string_view name) {
  const auto at = fields_.optional(name);
  return at ? &at->json : nullptr;
}

std::optional<std::string> Parameters::problem() {
  fields_.finish();
  if (!reader_.error()) return std::nullopt;
  return in_call(*reader_.error());
}

}  // namespace unietp
