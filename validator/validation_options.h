#pragma once

#include <filesystem>
#include <vector>

#include "akb/knowledge.h"
#include "simulation/profile.h"
#include "validator/stated_goal.h"

namespace unietp {

/// Facts and limits of one simulator, as physics needs them to rebuild its scenes.
struct ValidationBackend {
  const Knowledge* knowledge = nullptr;
  const Profile* profile = nullptr;
};

struct ValidationOptions {
  int threads = 1;
  double rest_m = 0.005;  // a body that moves farther than this when physics runs on was not at rest
  TextCheck check_text;   // none: instructions are not read
  std::vector<std::filesystem::path> against;  // finished data sets with which nothing may be shared
};

}  // namespace unietp
