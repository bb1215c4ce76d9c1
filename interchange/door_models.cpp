#include "interchange/door_models.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace unietp {

std::span<const DoorModel> door_models() {
  static constexpr std::array<DoorModel, 20> kModels{{
      {"Doorframe_1", 1.081, 2.130},        {"Doorframe_10", 1.041, 2.102},       {"Doorframe_2", 1.000, 2.073},
      {"Doorframe_3", 1.024, 2.087},        {"Doorframe_4", 1.043, 2.104},        {"Doorframe_5", 1.038, 2.096},
      {"Doorframe_6", 1.038, 2.107},        {"Doorframe_7", 1.036, 2.096},        {"Doorframe_8", 1.051, 2.099},
      {"Doorframe_9", 0.998, 2.074},        {"Doorframe_Double_1", 1.997, 2.130}, {"Doorframe_Double_10", 1.992, 2.102},
      {"Doorframe_Double_2", 1.914, 2.073}, {"Doorframe_Double_3", 1.943, 2.087}, {"Doorframe_Double_4", 1.994, 2.105},
      {"Doorframe_Double_5", 1.940, 2.096}, {"Doorframe_Double_6", 1.995, 2.106}, {"Doorframe_Double_7", 1.947, 2.096},
      {"Doorframe_Double_8", 1.965, 2.099}, {"Doorframe_Double_9", 1.910, 2.075},
  }};
  return kModels;
}

const DoorModel& door_model_for(double width) {
  const auto models = door_models();
  return *std::min_element(models.begin(), models.end(), [&](const DoorModel& a, const DoorModel& b) {
    return std::abs(a.width - width) < std::abs(b.width - width);
  });
}

}  // namespace unietp
