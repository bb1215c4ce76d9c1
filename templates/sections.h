#pragma once

#include <span>
#include <string_view>

namespace unietp {

/// A section of a template file.
struct TemplateSection {
  std::string_view name;   // "goal"
  bool required = true;    // may not be left out
  std::string_view usage;  // "(goal f)"
  std::string_view says;   // one line for people
};
/// In the order in which a template is printed; a file may have them in any.
std::span<const TemplateSection> template_sections();

/// A shape that a start constraint may have, or a literal of its body (init_shape.h).
struct StartForm {
  std::string_view usage, says;
};
/// In the order in which help lists them.
std::span<const StartForm> start_shapes();
std::span<const StartForm> start_literal_forms();

}  // namespace unietp
