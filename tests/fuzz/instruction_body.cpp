#include "../annotator/small_knowledge.h"
#include "annotator/parse.h"
#include "bodies.h"
#include "fuzz_bodies.h"
#include "support.h"

namespace unietp::fuzz {

bool instruction_body(std::string_view text) {
  static const NounTable nouns(testing_support::small_knowledge(), {});
  const auto goal = parse_with(text, nouns);
  if (!goal) {
    require(!goal.error().message.empty() && goal.error().pos.column >= 1);
    require(goal.error().pos.column <= static_cast<int>(text.size()) + 1);
    return false;
  }
  check_formula(*goal, FormulaUse::Goal);
  return true;
}

}  // namespace unietp::fuzz
