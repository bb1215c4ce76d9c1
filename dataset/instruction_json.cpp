#include "dataset/instruction_json.h"

#include <nlohmann/json.hpp>

#include "scene/json_text.h"

namespace unietp {

nlohmann::ordered_json instruction_to_json(const Instruction& instruction) {
  nlohmann::ordered_json json{{"text", instruction.text},
                              {"writer", instruction.writer},
                              {"style", name_of(instruction.style)},
                              {"checks", instruction.checks}};
  if (!instruction.why.empty()) json["why"] = instruction.why;
  return json;
}

std::string reworded_line(const std::string& line, const Instruction& instruction) {
  auto json = nlohmann::ordered_json::parse(line);
  json["instruction"] = instruction_to_json(instruction);
  std::string text;
  JsonText(text).tree(json);
  return text;
}

}  // namespace unietp
