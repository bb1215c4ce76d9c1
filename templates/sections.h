#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace unietp {

enum class SectionType : std::uint8_t {  // of a template
  Name,
  Purpose,
  Split,
  Refinement,
  Simulators,
  Parameters,
  Constraints,
  Init,
  Goal,
  Instruction,
};

/// A section of a template file.
struct TemplateSection {
  SectionType type = SectionType::Name;
  std::string_view name;   // "goal"
  bool required = true;    // may not be left out
  std::string_view usage;  // "(goal f)"
  std::string_view says;   // one line for people
};
/// In the order in which a template is printed; a file may have them in any.
std::span<const TemplateSection> template_sections();
/// nullptr when there is none of that name.
const TemplateSection* section_named(std::string_view name);

/// A shape that a start constraint may have, or a literal of its body (init_shape.h).
struct StartForm {
  std::string_view usage, says;
};
/// In the order in which help lists them.
std::span<const StartForm> start_shapes();
std::span<const StartForm> start_literal_forms();

}  // namespace unietp
