#pragma once

#include <nlohmann/json_fwd.hpp>

#include "annotator/instruction.h"

namespace unietp {

/// The field `instruction` of a line of tasks.jsonl.
nlohmann::ordered_json instruction_to_json(const Instruction& instruction);

}  // namespace unietp
