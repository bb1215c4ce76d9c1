#pragma once

#include <string>
#include <string_view>

namespace unietp {

/// What most likely has to change when candidates of a template are given up for this reason, in one sentence; "" for a
/// reason that says all itself.
std::string_view hint_for(std::string_view reason);

}  // namespace unietp
