#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace unietp {

/// What holds at each moment that a step of a plan leads through, in order, of which the last is when all of it is
/// done: several of a composite action, else one. `holding`: the names that hold at the start and at each moment since.
/// `at`: the moment before the step, which becomes its last. `moments`: how many the record of the step has
/// (StepRecord::moments), none where it has one.
std::vector<std::vector<std::string>> moments_of_step(const std::vector<std::vector<std::string>>& holding,
                                                      std::size_t& at, std::size_t moments);

}  // namespace unietp
