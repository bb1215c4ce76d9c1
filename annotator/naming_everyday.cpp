#include <algorithm>

#include "annotator/naming.h"

namespace unietp {

bool Naming::is_alone(const Domain& noun) const {
  if (noun.kind != Domain::Kind::Categories || noun.members.size() != 1 || noun.members[0].slice) return false;
  return std::binary_search(wording_.alone.begin(), wording_.alone.end(), noun.members[0].category);
}

Words Naming::first_everyday(const NounPhrase& said, const Noun& noun, Place place, const Description& description) {
  const std::string tail = description.tail(false);
  const bool described = (!said.modifiers.empty() || !said.done.empty()) && !place.wanted;
  const auto others = std::count_if(named_.begin(), named_.end(), [&](const Named& other) {
    return other.noun == said.noun && other.variable != said.variable;
  });
  const bool alone = is_alone(said.noun) && !place.wanted && !place.chosen && others == 0;
  // Within a description "the desk" may be read otherwise than it is meant.
  const bool the = alone && (!place.inside_description || rng_.chance(0.85));
  if (the || place.unique || (described && !place.inside_description))
    return {"the " + description.before + noun.singular + tail};
  const std::string one = description.before + (noun.countable ? noun.singular : "piece of " + noun.singular) + tail;
  if (place.beside_every) return {"one " + one};
  return {noun.countable ? with_article(one) : "some " + description.before + noun.singular + tail};
}

}  // namespace unietp
