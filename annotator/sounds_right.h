#pragma once

#include <string>

namespace unietp {

/// Whether a text has none of the phrases that a person would not say, though they can be read: "fill something to
/// drink from with water", "put something to read on on the bed", "grab me it", "pick up something to dry them with",
/// "wash something to cover up with", which who needs it now does not want wet, "both pieces of juice", "a couple of
/// shoes".
bool sounds_right(const std::string& text);

}  // namespace unietp
