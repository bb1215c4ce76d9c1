#include <algorithm>

#include "annotator/naming.h"
#include "annotator/words_for_writing.h"
#include "core/text.h"

namespace unietp {
namespace {

bool is_direct(const Complement& modifier, Place place) {
  if (modifier.negated || modifier.object.empty()) return false;
  using P = Predicate;
  if (place.bare_room && modifier.predicate == P::InRoom) return true;
  const bool where = modifier.predicate == P::On || modifier.predicate == P::Inside ||
                     modifier.predicate == P::InRoom || modifier.predicate == P::NextTo;
  return modifier.converse || modifier.predicate == P::Nearest || (place.bare && where);
}

/// "The larger dirty red wooden box", "the dirty kitchen cabinet".
int place_before_noun(const Complement& modifier) {
  using P = Predicate;
  if (modifier.predicate == P::Size) return 0;
  if (modifier.predicate == P::Color) return 2;
  if (modifier.predicate == P::Material) return 3;
  return modifier.object.empty() ? 1 : 4;
}

}  // namespace

/// The modifier as a word before the noun, or "" when it is none.
std::string Naming::adjective(const Complement& modifier, bool two) {
  using P = Predicate;
  if (modifier.negated || !modifier.object.empty()) return "";
  if (modifier.predicate == P::Color) return lexicon_.is_color(modifier.symbol) ? modifier.symbol : "";
  if (modifier.predicate == P::Material) {
    if (!lexicon_.is_material(modifier.symbol)) return "";
    return modifier.symbol == "wood" ? "wooden" : modifier.symbol;
  }
  if (modifier.predicate == P::Size) {
    const bool large = modifier.symbol == "large";
    if (!large && modifier.symbol != "small") return "";
    if (two) return large ? pick({"larger", "bigger"}) : "smaller";
    return large ? pick({"largest", "biggest"}) : "smallest";
  }
  const std::string word = state_word(modifier.predicate);
  return modifier.symbol.empty() && word.find(' ') == std::string::npos ? word : "";
}

/// Whether a room is said before a name: "the kitchen cabinet", "the bedroom side table", but "the upper cabinet in the
/// kitchen" and "the dining table in the dining room".
bool Naming::takes_room(const std::string& name) {
  const auto words = tokens_of(name);
  const bool table = words.size() == 2 && words.back().text == "table" && words.front().text != "dining";
  return (words.size() == 1 || table) && !name.ends_with("plant");
}

/// "the kitchen cabinet"
std::string Naming::room_before(const Complement& modifier, const NounPhrase& said) const {
  const bool fixed = everyday() && said.determiner == Determiner::New && !is_carried(said.noun);
  const bool room = (fixed || style_ == Style::Compound) && modifier.predicate == Predicate::InRoom &&
                    !modifier.negated && !modifier.object.empty() && modifier.object[0].noun.members.size() == 1;
  const auto* name = room ? lexicon_.display(modifier.object[0].noun.members[0].category) : nullptr;
  const auto* own = fixed && said.noun.members.size() == 1 ? lexicon_.display(said.noun.members[0].category) : nullptr;
  if (name == nullptr || (fixed && (own == nullptr || says_room(own->singular)))) return "";
  if (fixed && !takes_room(own->singular)) return "";
  return name->singular;
}

std::optional<Naming::Description> Naming::describe(const NounPhrase& said, Place place) {
  Description description;
  std::vector<const Complement*> rest;
  std::vector<const Complement*> modifiers;
  for (const Complement& modifier : said.modifiers) modifiers.push_back(&modifier);
  std::stable_sort(modifiers.begin(), modifiers.end(), [](const Complement* a, const Complement* b) {
    return place_before_noun(*a) < place_before_noun(*b);
  });
  for (const Complement* const one : modifiers) {
    const Complement& modifier = *one;
    std::string word = everyday() || description.before.empty() ? adjective(modifier, said.two) : "";
    if (word.empty()) word = room_before(modifier, said);
    const bool size = modifier.predicate == Predicate::Size;
    const bool needed = everyday() || size || style_ == Style::Ellipsis || style_ == Style::Compound;
    if (!word.empty() && (needed || rng_.chance(0.7))) {
      description.before += word + " ";
      description.of_two = size && said.two && !everyday() && rng_.chance(0.4);
    } else {
      rest.push_back(&modifier);
    }
  }
  for (const Complement* modifier : rest) {
    Place inside{.inside_description = true, .exact = place.exact};
    inside.unique =
        !place.exact && (modifier->predicate == Predicate::Nearest || modifier->predicate == Predicate::InRoom);
    inside.denied = modifier->negated;
    inside.near = modifier->predicate == Predicate::NextTo;
    inside.of_every = said.determiner == Determiner::Every;
    if (modifier->converse) {
      const auto object = phrase(modifier->object[0], inside);
      if (!object || rest.size() > 1) return std::nullopt;
      const bool held = modifier->predicate == Predicate::Inside;
      const std::string is = object->plural ? " are" : " is";
      description.directly = (held ? " where " : " on which ") + object->text +
                             (held             ? is + " kept"
                              : object->plural ? " stand"
                                               : " stands");
      continue;
    }
    const auto text = complement(*modifier, inside);
    if (!text) return std::nullopt;
    const bool stands =
        everyday() && !place.exact && modifier->predicate == Predicate::InRoom && !is_carried(said.noun);
    const bool direct = rest.size() == 1 && (is_direct(*modifier, place) || (stands && !modifier->negated));
    if (direct && (everyday() || modifier->predicate == Predicate::Nearest || rng_.chance(0.7))) {
      description.directly = " " + *text;
    } else {
      description.is += (description.is.empty() ? "" : " and ") + *text;
    }
  }
  description.short_is = everyday() && !description.is.starts_with("not ") && rng_.chance(0.8);
  const bool lasting = std::any_of(rest.begin(), rest.end(), [](const Complement* one) {
    return one->predicate == Predicate::Color || one->predicate == Predicate::Material ||
           one->predicate == Predicate::Size;
  });
  // "The mug that is in a sink is on a table" needs it.
  const bool now = !everyday() && (place.outcome || rng_.chance(0.3));
  if (!description.is.empty() && !lasting && now) description.is.insert(0, "now ");
  return description;
}

}  // namespace unietp
