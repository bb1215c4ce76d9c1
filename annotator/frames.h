#pragma once

#include <string>
#include <vector>

#include "core/rng.h"

namespace unietp {

/// The text with a capital letter in front and `end` behind.
std::string sentence(std::string text, char end);

/// A command as people give it: mostly as it is, seldom with a "please" or as a question. `is_first`: of the text.
std::string everyday_request(const std::string& command, bool is_first, Rng& rng);

/// A command in all the ways that people have besides the command itself: "Please …", "Can you …?". Only with "please"
/// where it forbids something.
std::vector<std::string> as_requests(const std::string& command);

/// A command in one of many frames: "I need you to …", "Could you please …?".
std::string framed_request(const std::string& command, bool is_first, Rng& rng);

}  // namespace unietp
