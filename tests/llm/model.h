#pragma once

#include <string>

#include "server.h"

namespace unietp::test {

/// A model that knows something of every category that it is asked about: reads the schema of the request and answers
/// all of it, the same each time. Gives the whole HTTP text.
std::string answer_all(const Received& received);

}  // namespace unietp::test
