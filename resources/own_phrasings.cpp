#include "resources/own_phrasings.h"

#include <algorithm>

namespace unietp {
namespace {

const Template* template_named(const Resources& resources, std::string_view name) {
  const auto& all = resources.templates;
  const auto found = std::find_if(all.begin(), all.end(), [&](const Template& one) { return one.name == name; });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace

std::span<const std::string> phrasings_of_template(const Resources& resources, std::string_view name) {
  const Template* known = template_named(resources, name);
  return known == nullptr ? std::span<const std::string>() : known->instructions;
}

bool is_known_template(const Resources& resources, std::string_view name) {
  return template_named(resources, name) != nullptr;
}

}  // namespace unietp
