#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "annotator/instruction.h"

namespace unietp {

/// The field `instruction` of a line of tasks.jsonl.
nlohmann::ordered_json instruction_to_json(const Instruction& instruction);

/// A line of tasks.jsonl with another instruction; all else stays as it stands.
std::string reworded_line(const std::string& line, const Instruction& instruction);

}  // namespace unietp
