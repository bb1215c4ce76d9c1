#include <cmath>

#include "annotator/judge.h"
#include "annotator/wording_request.h"
#include "bodies.h"
#include "fuzz_bodies.h"
#include "llm/batch.h"
#include "llm/retry_after.h"
#include "support.h"

namespace unietp::fuzz {

bool answers_body(std::string_view text) {
  const auto wait = retry_after_s(std::string(text), "Wed, 21 Oct 2015 07:28:00 GMT");
  require(!wait || (std::isfinite(*wait) && *wait >= 0));

  BatchAnswers answers;
  read_batch_answers("fuzz", text, answers);
  for (const Error& error : answers.unreadable) {
    check_error(error);
    require(error.pos.line >= 1);
  }
  bool sound = answers.unreadable.empty() && !answers.by_id.empty();
  for (const auto& [id, answer] : answers.by_id) {
    require(!id.empty());
    if (!answer) {
      check_error(answer.error());
      require(answers.failures.at(id) > 0);
      sound = false;
      continue;
    }
    const auto words = worded(*answer);
    if (!words) check_error(words.error());
    const auto goal = judged(*answer);
    if (!goal) check_error(goal.error());
    if (goal) check_formula(*goal, FormulaUse::Goal);
    sound = sound && (words || goal);
  }
  return sound;
}

}  // namespace unietp::fuzz
