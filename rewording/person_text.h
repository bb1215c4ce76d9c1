#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "annotator/instruction.h"
#include "core/result.h"
#include "resources/resources.h"
#include "rewording/worded_task.h"
#include "scene/scene.h"

namespace unietp {

/// Whether a person wrote or corrected the text of an instruction with this writer.
bool by_person(std::string_view writer);

/// An instruction that a person wrote, with the checks that it passed.
struct PersonText {
  Instruction instruction;
  std::vector<std::string> faults;  // empty when it passed all: form, read back as the goal, style
};

/// `english`: of the data set; `home`: the start scene. Both are what the validator reads the text with. Pure.
PersonText check_person_text(const std::string& text, const WordedTask& task, const Backend& backend, English english,
                             const Scene& home);

}  // namespace unietp
