#pragma once

#include <string>
#include <string_view>

namespace unietp {

/// Where brackets that do not match were probably forgotten: the first section of a template's text that opens, at the
/// beginning of a line, inside another one or behind the template's end. "; section 'goal' opens at line 7 while 2
/// brackets of the section before it are open", or "" when no section does.
std::string bracket_hint(std::string_view text);

}  // namespace unietp
