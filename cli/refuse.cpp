#include <cstdio>

#include "cli/commands.h"

namespace unietp {

Exit refuse(const std::vector<Error>& errors) {
  for (const auto& error : errors) (void)std::fprintf(stderr, "%s\n", format(error).c_str());
  return Exit::BadInput;
}

Exit refuse(const Error& error) { return refuse(std::vector<Error>{error}); }

}  // namespace unietp
