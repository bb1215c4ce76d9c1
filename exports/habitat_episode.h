#pragma once

#include <map>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "record/dataset_reader.h"

namespace unietp {

/// Where the exported folder stands for Habitat, which is started from the folder above `data`.
inline constexpr const char* kHabitatRoot = "data/unietp/";

/// A task as an episode of habitat-lab's RearrangeDataset-v0. Movable objects are `rigid_objs`, in the order of the
/// start; opened furniture is in `ao_states`. `targets` are the objects that rest elsewhere at the end of the
/// demonstration in M1, with the pose that they have there. Habitat has no states such as dirt or heat, so what the
/// task asks for stands in `info.unietp`: instruction, goal, names of our objects, and the demonstration's actions.
/// `names`: handles of the furniture, by our id, as write_habitat_with_stand_ins gives them.
nlohmann::ordered_json habitat_episode(const FinishedTask& task, const std::map<std::string, std::string>& names);

}  // namespace unietp
