#include <algorithm>

#include "annotator/naming.h"
#include "core/text.h"

namespace unietp {
namespace {

constexpr double kOneOf = 0.2;  // of the places of which there are several

bool says_its_room(const Complement& modifier) {
  return modifier.predicate == Predicate::InRoom && !modifier.negated && !modifier.converse;
}

}  // namespace

bool Naming::is_alone(const Domain& noun) const {
  if (noun.kind != Domain::Kind::Categories || noun.members.size() != 1 || noun.members[0].slice) return false;
  return std::binary_search(wording_.alone.begin(), wording_.alone.end(), noun.members[0].category);
}

bool Naming::is_carried(const Domain& noun) const {
  const NounTable::Name* name = noun.members.size() == 1 ? lexicon_.display(noun.members[0].category) : nullptr;
  return name != nullptr && name->movable;
}

bool Naming::has_lid(const Domain& noun) const {
  const NounTable::Name* name = noun.members.size() == 1 ? lexicon_.display(noun.members[0].category) : nullptr;
  return name != nullptr && lexicon_.everyday()->ends_as(name->singular, NameUse::HasLid);
}

bool Naming::is_plant(const Domain& noun) const {
  const NounTable::Name* name = noun.members.size() == 1 ? lexicon_.display(noun.members[0].category) : nullptr;
  return name != nullptr && lexicon_.everyday()->ends_as(name->singular, NameUse::Plant);
}

bool Naming::heats_food(const Domain& noun) const {
  const NounTable::Name* name = noun.members.size() == 1 ? lexicon_.display(noun.members[0].category) : nullptr;
  return name != nullptr && lexicon_.everyday()->ends_as(name->singular, NameUse::HeatsFood);
}

bool Naming::puts_away(const Domain& noun) const {
  const NounTable::Name* name = noun.members.size() == 1 ? lexicon_.display(noun.members[0].category) : nullptr;
  return name != nullptr && !name->movable && lexicon_.everyday()->ends_as(name->singular, NameUse::PutsAway);
}

bool Naming::comes_from_a_shaker(const std::string& substance) const {
  const std::string named = replace_all(substance, "-", "_");  // lemon-pepper_seasoning
  return substance == "black_pepper" || lexicon_.display(named + "_shaker") != nullptr;
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

bool Naming::is_unique(const NounPhrase& said) const {
  if (is_alone(said.noun)) return true;
  const bool other = std::any_of(named_.begin(), named_.end(), [&](const Named& one) {
    return one.noun == said.noun && one.variable != said.variable;
  });
  return !other && std::binary_search(wording_.unique.begin(), wording_.unique.end(), said.variable);
}

bool Naming::will_be_the(const NounPhrase& said) const {
  return said.determiner == Determiner::New && (was_named(said.variable) || !said.modifiers.empty() || is_unique(said));
}

/// "One of the bedrooms", where there are several: of rooms always, of what stands in them at times, and beside what
/// there is one of, "the globe and one of the plant pots".
bool Naming::says_one_of(const NounPhrase& said, const Noun& noun, Place place, bool described) {
  if (said.there < 2 || described || !noun.countable || noun.function || place.inside_description || place.wanted ||
      place.chosen)
    return false;
  const bool room = lexicon_.is_room_type(said.noun.members[0].category);
  return room || place.beside_the || says_room(noun.singular) || (!is_carried(said.noun) && rng_.chance(kOneOf));
}

/// "Kitchen counter": nobody has "a kitchen counter" at home.
bool Naming::says_room(const std::string& name) const {
  const auto words = tokens_of(name);
  const std::size_t room = lexicon_.room_at(words, 0).length;
  return room > 0 && room < words.size();
}

std::string Naming::pair_name(const Domain& domain, const Noun& noun) const {
  if (domain.members.size() != 1 || domain.members[0].slice) return "";
  const NounTable::Name* own = lexicon_.display(domain.members[0].category);
  return own != nullptr && own->singular == noun.singular ? lexicon_.without_set(domain.members[0].category) : "";
}

Words Naming::first_everyday(const NounPhrase& said, const Noun& noun, Place place, const Description& description) {
  const std::string tail = description.tail(is_plural(noun));
  const bool described = !said.modifiers.empty() && !place.wanted;
  // Where something is named so already it is the same one.
  const bool alone = is_unique(said) && !place.wanted && !place.chosen;
  // What describes something is told apart by it: "the mug on the desk", also where there is another desk.
  const bool describes = place.inside_description && !place.denied && said.modifiers.empty() &&
                         said.noun.kind == Domain::Kind::Categories && said.there < 2 &&
                         !lexicon_.is_room_type(said.noun.members[0].category) && mentions_of(said.noun) == 1;
  // Within a description "the desk" may be read otherwise than it is meant.
  const bool the = (alone || describes) &&
                   (!place.inside_description || is_alone(said.noun) || wording_.pronouns == 1 || rng_.chance(0.5));
  // "A kitchen cabinet", "a lower cabinet in the kitchen", where it has several.
  const bool one_of_a_room =
      said.there > 1 && !is_carried(said.noun) && said.modifiers.size() == 1 && says_its_room(said.modifiers[0]);
  const bool definite = the || place.unique || (described && !place.inside_description && !one_of_a_room);
  if (const std::string pair = definite ? pair_name(said.noun, noun) : ""; !pair.empty())
    return {"the " + description.before + pair + description.tail(true), true};
  if (definite) return {"the " + description.before + noun.singular + tail, is_plural(noun)};
  const std::string one = description.before + (noun.countable ? noun.singular : "piece of " + noun.singular) + tail;
  // "The mug on one of the desks", of which there are several.
  const bool one_identifies = place.inside_description && !place.denied && !place.near && said.there > 1 &&
                              !described && noun.countable && !noun.function && !is_carried(said.noun);
  // "All the pants that are on the beds": on any of them.
  if (one_identifies) return {(place.of_every ? "the " : "one of the ") + noun.plural, place.of_every};
  if (place.beside_every) {
    const bool several = said.there > 1 && !described && noun.countable && !is_carried(said.noun);
    const bool room = !said.noun.members.empty() && lexicon_.is_room_type(said.noun.members[0].category);
    if (several && (room || rng_.chance(kOneOf))) return {"one of the " + noun.plural};
    return {"the same " + one};
  }
  // "Put one pillow on the bed and the other on the couch."
  const auto is_this = [&](const auto& two) { return two.first == said.variable; };
  if (said.there == 2 && place.moved && noun.countable &&
      std::any_of(plan_.distinct.begin(), plan_.distinct.end(), is_this))
    return {"one " + one};
  const bool of_pairs = noun.plural.starts_with("pairs of ");  // "a pair of pants"
  if (!of_pairs && says_one_of(said, noun, place, described)) return {"one of the " + noun.plural};
  if (noun.countable) return {with_article(one)};
  return {"some " + description.before + noun.singular + tail, is_plural(noun)};
}

}  // namespace unietp
