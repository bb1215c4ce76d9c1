#pragma once

#include <vector>

#include "record/dataset_reader.h"
#include "record/manifest_record.h"
#include "scene/scene.h"
#include "validator/validation_options.h"

namespace unietp {

/// The simulator's facts and limits among `backends`, which are in the order of kSimulators.
inline const ValidationBackend& backend_of(const std::vector<ValidationBackend>& backends, const Scene& scene) {
  return backends[static_cast<std::size_t>(scene.simulator)];
}

}  // namespace unietp
