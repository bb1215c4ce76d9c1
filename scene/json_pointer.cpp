#include "scene/json_pointer.h"

#include "core/text.h"

namespace unietp {

std::string at_pointer(std::string_view where, std::string_view pointer) {
  return pointer.empty() ? std::string(where) : std::string(where) + "#" + std::string(pointer);
}

std::string pointer_token(std::string_view name) {
  return replace_all(replace_all(std::string(name), "~", "~0"), "/", "~1");
}

}  // namespace unietp
