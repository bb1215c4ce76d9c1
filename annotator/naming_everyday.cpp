#include <algorithm>

#include "annotator/naming.h"

namespace unietp {

bool Naming::is_alone(const Domain& noun) const {
  if (noun.kind != Domain::Kind::Categories || noun.members.size() != 1 || noun.members[0].slice) return false;
  return std::binary_search(wording_.alone.begin(), wording_.alone.end(), noun.members[0].category);
}

bool Naming::is_carried(const Domain& noun) const {
  const NounTable::Name* name = noun.members.size() == 1 ? lexicon_.display(noun.members[0].category) : nullptr;
  return name != nullptr && name->movable;
}

bool Naming::comes_from_a_shaker(const std::string& substance) const {
  return substance == "black_pepper" || lexicon_.display(substance + "_shaker") != nullptr;
}

/// How many phrases of the plan are of this noun.
int Naming::mentions_of(const Domain& noun) const {
  int count = 0;
  const auto add_clauses = [&](const auto& self, const std::vector<Clause>& clauses) -> void {
    const auto add = [&](const auto& again, const NounPhrase& phrase) -> void {
      count += phrase.noun == noun ? 1 : 0;
      for (const Complement& modifier : phrase.modifiers)
        for (const NounPhrase& object : modifier.object) again(again, object);
    };
    for (const Clause& clause : clauses) {
      for (const NounPhrase& subject : clause.subjects) add(add, subject);
      for (const Complement& said : clause.complements)
        for (const NounPhrase& object : said.object) add(add, object);
      for (const NounPhrase& there : clause.given) add(add, there);
      self(self, clause.parts);
    }
  };
  for (const Requirement& requirement : plan_.message) add_clauses(add_clauses, requirement.clauses);
  return count;
}

Words Naming::first_everyday(const NounPhrase& said, const Noun& noun, Place place, const Description& description) {
  const std::string tail = description.tail(is_plural(noun));
  const bool described = !said.modifiers.empty() && !place.wanted;
  const auto others = std::count_if(named_.begin(), named_.end(), [&](const Named& other) {
    return other.noun == said.noun && other.variable != said.variable;
  });
  // Of what is carried about, "a mug" where there is one is what people say as often.
  const bool carried =
      !place.inside_description && !described && !place.beside_every && is_carried(said.noun) && rng_.chance(0.5);
  // "The heated egg" would be hot already.
  const bool alone = is_alone(said.noun) && !carried && !place.wanted && !place.chosen && others == 0 && !is_made(said);
  // What describes something is told apart by it: "the mug on the desk", also where there is another desk.
  const bool describes = place.inside_description && !place.denied && said.modifiers.empty() &&
                         said.noun.kind == Domain::Kind::Categories &&
                         !lexicon_.is_room_type(said.noun.members[0].category) && mentions_of(said.noun) == 1;
  // Within a description "the desk" may be read otherwise than it is meant.
  const bool the = (alone || describes) && (!place.inside_description || rng_.chance(0.95));
  if (the || place.unique || (described && !place.inside_description))
    return {"the " + description.before + noun.singular + tail, is_plural(noun)};
  const std::string one = description.before + (noun.countable ? noun.singular : "piece of " + noun.singular) + tail;
  if (place.beside_every) return {"the same " + one};
  if (noun.countable) return {with_article(one)};
  return {"some " + description.before + noun.singular + tail, is_plural(noun)};
}

}  // namespace unietp
