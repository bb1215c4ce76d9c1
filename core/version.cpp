#include "core/version.h"

namespace unietp {

std::string_view program_version() { return UNIETP_VERSION; }
std::string_view program_build() { return UNIETP_BUILD; }

}  // namespace unietp
