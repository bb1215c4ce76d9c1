#include "interchange/formats.h"

namespace unietp {

const std::vector<std::string>& scene_format_names() {
  static const std::vector<std::string> names{"ithor", "procthor", "virtualhome", "replicacad", "hssd", "behavior"};
  return names;
}

}  // namespace unietp
