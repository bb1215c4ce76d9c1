#include "../annotator/small_knowledge.h"
#include "annotator/everyday_names.h"
#include "bodies.h"
#include "fuzz_bodies.h"
#include "grounding/household.h"
#include "sense/common_sense.h"
#include "sense/generic_words.h"
#include "sense/place_uses.h"
#include "sense/question.h"
#include "sense/start_states.h"
#include "sense/use_states.h"
#include "support.h"

namespace unietp::fuzz {

namespace {

/// The same tables as the household of a simulator's homes.
void check_household(const std::filesystem::path& folder, bool sound) {
  static const Knowledge knowledge = testing_support::small_knowledge();
  const auto household = read_household(folder, knowledge);
  require(check_result(household) || !sound);
  if (!household) return;
  for (const Category& category : knowledge.categories()) {
    for (const LikelyState& row : household->states_of(category.name, Predicate::Inside, "Fridge"))
      require(row.share >= 0 && row.share <= 1);
  }
}

}  // namespace

bool sense_body(std::string_view text) {
  static const Folder folder("sense");
  constexpr std::string_view kBetween = "====\n";
  for (const char* file :
       {"kinds.csv", "categories.csv", "judged.csv", "counts.csv", "rules.csv", "words.csv", "hypernyms.csv",
        "start_states.csv", "special_places.csv", "companions.csv", "place_uses.csv", "use_states.csv",
        "generic_words.csv", "everyday_names.csv", "rare_names.csv", "look_alikes.csv", "name_uses.csv"}) {
    const std::size_t end = text.find(kBetween);
    folder.write(file, text.substr(0, end));
    text = end == std::string_view::npos ? "" : text.substr(end + kBetween.size());
  }
  std::vector<Error> errors;
  const CommonSense sense = read_common_sense(folder.path(), errors);
  const WordKinds words = read_word_kinds(folder.path(), sense.kinds(), errors);
  const StartStates states = read_start_states(folder.path() / "start_states.csv", sense.kinds(), errors);
  (void)read_use_states(folder.path() / "use_states.csv", sense.kinds(), errors);
  (void)read_generic_words(folder.path() / "generic_words.csv", sense.kinds(), errors);
  (void)read_place_uses(folder.path() / "place_uses.csv", sense.kinds(), errors);
  for (const Error& error : errors) check_error(error);
  std::vector<Error> of_names;
  const EverydayNames names = read_everyday_names(folder.path(), of_names);
  for (const Error& error : of_names) check_error(error);
  (void)names.is_said(names.of("oven stove", English::Gb), English::Us);
  for (const Kind& kind : sense.kinds().all()) {
    const auto lineage = sense.kinds().lineage(kind.name);
    require(!lineage.empty() && lineage.size() <= sense.kinds().all().size());
    const Thing thing{kind.name, kind.singular, {}};
    for (const char* role : {"cook", "on:counter", "fill:water", "cook>on:plate", "found:in:cup"}) {
      const Sense answer = sense.grade(thing, role);
      require(answer.score >= 0 && answer.score <= 1);
    }
    (void)sense.together(thing, thing);
    for (const auto& row : states.of(kind.name, "in:" + kind.name)) require(row.share >= 0 && row.share <= 1);
    const auto named = words.of_word(kind.name);
    require(!errors.empty() || !named || sense.kinds().find(*named) != nullptr);
  }
  check_household(folder.path(), errors.empty());
  return errors.empty();
}

bool question_body(std::string_view text) {
  static const Knowledge knowledge = testing_support::small_knowledge();
  const auto goal = read_question(text, knowledge);
  if (!goal) {
    require(!goal.error().message.empty());
    return false;
  }
  check_formula(*goal, FormulaUse::Goal);
  return true;
}

}  // namespace unietp::fuzz
