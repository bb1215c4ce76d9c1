#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace unietp {

/// What holds after a step of a plan, as the files of a simulator have it: `holds`, and where the step leads through
/// several moments `moments`, one list of names for each, of which the last is `holds` again. `holding`: the names that
/// hold at the start and at each moment since. `at`: the moment before the step, which becomes its last. `moments`: how
/// many the record of the step has (StepRecord::moments), none where it has one.
void write_what_holds(nlohmann::ordered_json& step, const std::vector<std::vector<std::string>>& holding,
                      std::size_t& at, std::size_t moments);

}  // namespace unietp
