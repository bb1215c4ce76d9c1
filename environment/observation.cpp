#include "environment/observation.h"

#include <tuple>

namespace unietp {

bool operator==(const Observation& a, const Observation& b) {
  const auto fields = [](const Observation& one) {
    return std::tie(one.instruction, one.boxes, *one.home, one.pose, one.last, one.results, one.held, one.step,
                    one.steps_left, one.failures_left, one.has_picture, one.image_width, one.image_height, one.over);
  };
  return fields(a) == fields(b);
}

}  // namespace unietp
