#include <array>
#include <utility>

#include "templates/template.h"

namespace unietp {
namespace {

constexpr std::array<std::pair<Split, std::string_view>, 5> kNames = {{
    {Split::Atomic, "atomic"},
    {Split::Compositional, "compositional"},
    {Split::Logical, "logical"},
    {Split::InstanceGrounding, "instance_grounding"},
    {Split::Linguistic, "linguistic"},
}};

}  // namespace

std::string_view name_of(Split split) {
  for (const auto& [value, name] : kNames) {
    if (value == split) return name;
  }
  return "";
}

std::optional<Split> split_named(std::string_view name) {
  for (const auto& [value, text] : kNames) {
    if (text == name) return value;
  }
  return std::nullopt;
}

}  // namespace unietp
