#include "core/unknown_name.h"

#include "core/text.h"

namespace unietp {

Error unknown_name_error(std::string_view option, std::string_view name, const std::vector<std::string>& accepted) {
  std::string message = "unknown name \"" + std::string(name) + "\"";
  if (const auto near = nearest_name(name, accepted); !near.empty()) message += ", did you mean \"" + near + "\"";
  return {Error::Kind::Usage, std::string(option), {}, message + "; accepted: " + join(accepted, ", ")};
}

}  // namespace unietp
