#pragma once

#include <cstdint>

#include "scene/scene.h"

namespace unietp {

/// What a device that is switched on shows.
enum class Device : std::uint8_t {
  None,       // cannot be switched
  Lamp,       // glows and lights what is near it
  Screen,     // shows a picture on its front
  Burner,     // glows on its top
  Tap,        // water runs
  Flame,      // burns at its top
  Appliance,  // a lit window and a lamp on its front
};

/// By the words of its category, of nodes that have a state of power.
Device device_of(const Node& node);

}  // namespace unietp
