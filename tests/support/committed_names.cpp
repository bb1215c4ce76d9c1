#include "tests/support/committed_names.h"

#include <filesystem>
#include <stdexcept>

#include "annotator/parse.h"

namespace unietp {

const SharedValue<EverydayNames>& committed_names() {
  static const SharedValue<EverydayNames> kNames = [] {
    std::vector<Error> errors;
    auto names = read_everyday_names(std::filesystem::path(UNIETP_SOURCE_DIR) / "data/english", errors);
    if (!errors.empty()) throw std::runtime_error(format(errors.front()));
    return names;
  }();
  return kNames;
}

Result<Instruction> write_instruction(const Specification& specification, const Knowledge& knowledge, Rng rng) {
  return write_instruction(specification, knowledge, NounTable(knowledge, committed_names()), {}, rng);
}

std::vector<std::string> check_instruction(const std::string& text, const Specification& specification,
                                           const Knowledge& knowledge) {
  return check_instruction(text, specification, knowledge, NounTable(knowledge, committed_names()));
}

Result<Formula> parse_instruction(std::string_view text, const Knowledge& knowledge) {
  return parse_with(text, NounTable(knowledge, committed_names()));
}

}  // namespace unietp
