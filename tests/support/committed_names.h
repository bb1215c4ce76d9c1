#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "annotator/everyday_names.h"
#include "annotator/instruction.h"
#include "annotator/noun_table.h"
#include "core/shared_value.h"

namespace unietp {

/// The committed everyday names (data/english), read once a process. Throws when the tables are bad.
const SharedValue<EverydayNames>& committed_names();

/// The functions of annotator/instruction.h and parse.h with a table of nouns made for one text, and default options.
Result<Instruction> write_instruction(const Specification& specification, const Knowledge& knowledge, Rng rng);
std::vector<std::string> check_instruction(const std::string& text, const Specification& specification,
                                           const Knowledge& knowledge);
Result<Formula> parse_instruction(std::string_view text, const Knowledge& knowledge);

}  // namespace unietp
