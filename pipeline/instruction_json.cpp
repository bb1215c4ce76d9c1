#include "pipeline/instruction_json.h"

#include <nlohmann/json.hpp>

namespace unietp {

nlohmann::ordered_json instruction_to_json(const Instruction& instruction) {
  nlohmann::ordered_json json{{"text", instruction.text},
                              {"writer", instruction.writer},
                              {"style", instruction.style},
                              {"checks", instruction.checks}};
  if (!instruction.why.empty()) json["why"] = instruction.why;
  return json;
}

}  // namespace unietp
