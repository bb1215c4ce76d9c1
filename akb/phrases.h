#pragma once

#include <string>
#include <string_view>

namespace unietp {

// What is wrong with an English phrase that comes from outside, from a closed list of reasons; "" when nothing is.

/// A name of a thing: "bedside clock". Lower-case words, 2 to 40 bytes.
std::string_view wrong_with_synonym(std::string_view text);
/// What a thing is for: "something to drink from". Lower case, 8 to 60 bytes; begins with something, somewhere,
/// someone, some, a, an or the.
std::string_view wrong_with_function(std::string_view text);
/// Why somebody would want it: "I must get up early tomorrow." One sentence of 8 to 80 bytes.
std::string_view wrong_with_context(std::string_view text);

/// True when `words` stands in `text` as words of its own.
bool names_it(std::string_view text, std::string_view words);

}  // namespace unietp
