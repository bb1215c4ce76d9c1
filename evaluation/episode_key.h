#pragma once

#include <string>
#include <tuple>

#include "scene/action.h"

namespace unietp {

/// Which episode: a task in a mode, done again `repeat` times, counted from 1.
struct EpisodeKey {
  std::string task;
  Mode mode = Mode::M1;
  int repeat = 1;
  bool operator==(const EpisodeKey&) const = default;
  auto operator<=>(const EpisodeKey& other) const {
    return std::tie(task, mode, repeat) <=> std::tie(other.task, other.mode, other.repeat);
  }
};

}  // namespace unietp
