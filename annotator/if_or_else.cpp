#include "annotator/if_or_else.h"

#include "annotator/frames.h"
#include "annotator/words_for_writing.h"
#include "scene/states.h"

namespace unietp {
namespace {

using Text = std::optional<std::string>;

bool puts_one(const Clause& clause) {
  if (clause.kind != Clause::Kind::Simple || clause.subjects.size() != 1 || clause.complements.size() != 1)
    return false;
  const Complement& place = clause.complements[0];
  const bool put = place.predicate == Predicate::On || place.predicate == Predicate::Inside;
  return put && !place.negated && clause.subjects[0].determiner == Determiner::New &&
         clause.subjects[0].modifiers.empty();
}

}  // namespace

bool says_if_or_else(const Clause& clause) {
  if (clause.kind != Clause::Kind::Or || clause.parts.size() != 2) return false;
  const Clause &open = clause.parts[0], &shut = clause.parts[1];
  if (!puts_one(open) || !puts_one(shut) || open.subjects[0].noun != shut.subjects[0].noun) return false;
  if (shut.given.size() != 1 || !open.given.empty()) return false;
  const NounPhrase &container = open.complements[0].object[0], &there = shut.given[0];
  const auto one_state = [](const NounPhrase& phrase) {
    return phrase.modifiers.size() == 1 && phrase.modifiers[0].object.empty() && !phrase.modifiers[0].negated;
  };
  return container.noun == there.noun && one_state(container) && one_state(there) &&
         opposite_of(container.modifiers[0].predicate) == there.modifiers[0].predicate;
}

std::optional<std::string> if_or_else(const Clause& clause, Naming& naming, ClauseWriter& clauses) {
  if (!says_if_or_else(clause)) return std::nullopt;
  const std::size_t before = naming.named_count();
  const Clause& open = clause.parts[0];
  NounPhrase container = open.complements[0].object[0];
  const std::string state = state_word(container.modifiers[0].predicate);
  container.modifiers.clear();
  const auto there = naming.phrase(container, {});
  if (!there || !there->text.starts_with("the ")) return std::nullopt;
  const Text first = clauses.command(open);
  if (!first) return std::nullopt;
  naming.set_topic("");  // "put it on the bed" could be the machine
  const auto again = naming.phrase(open.subjects[0], {});
  const Text where = again ? naming.complement(clause.parts[1].complements[0], {}) : std::nullopt;
  naming.forget_after(before);
  if (!where) return std::nullopt;
  // "Put a plate in it. If not, put one on the counter.": of several, it need not be the same.
  const auto name = naming.is_alone(open.subjects[0].noun) ? std::nullopt : naming.singular(open.subjects[0].noun);
  const std::string another = name && where->find(" one of ") != Text::value_type::npos ? with_article(*name) : "one";
  const std::string thing = again->plural ? "them" : name ? another : "it";
  return sentence("if " + there->text + " is " + state + ", " + *first, '.') + " " +
         sentence("if not, put " + thing + " " + *where, '.');
}

}  // namespace unietp
