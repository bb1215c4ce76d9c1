#include "annotator/naming.h"

#include <algorithm>
#include <array>

#include "annotator/words_for_writing.h"
#include "core/text.h"

namespace unietp {

std::string number_word(int number) {
  static constexpr std::array kWords{"zero",  "one",   "two",  "three", "four",   "five",  "six",
                                     "seven", "eight", "nine", "ten",   "eleven", "twelve"};
  return number >= 0 && number < static_cast<int>(kWords.size()) ? kWords[number] : std::to_string(number);
}

std::string Naming::pick(std::initializer_list<const char*> choices) {
  return *(choices.begin() + rng_.below(choices.size()));
}

bool Naming::was_named(const std::string& variable) const {
  return std::any_of(named_.begin(), named_.end(), [&](const Named& n) { return n.variable == variable; });
}

bool Naming::was_named_kind(const Domain& noun) const {
  return std::find(counted_.begin(), counted_.end(), noun) != counted_.end() ||
         std::any_of(named_.begin(), named_.end(), [&](const Named& other) { return other.noun == noun; });
}

/// Whether the home may have what is called so.
bool Naming::may_mean_what_is_there(const std::string& name) const {
  if (!lexicon_.is_name(name)) return false;
  const auto nouns = lexicon_.noun_at(tokens_of(name), 0).nouns;
  return wording_.there.empty() || std::any_of(nouns.begin(), nouns.end(), [&](const Domain& noun) {
           return !noun.members[0].slice &&
                  std::binary_search(wording_.there.begin(), wording_.there.end(), noun.members[0].category);
         });
}

std::optional<std::string> Naming::name_of(const Domain::Member& member, bool plural, bool& countable) {
  auto found = chosen_.find(member.category);
  if (found == chosen_.end()) {
    const NounTable::Name* display = lexicon_.display(member.category);
    if (display == nullptr) return std::nullopt;
    NounTable::Name name = *display;
    // What a text of another style is about is not to be found by the usual names alone.
    const bool other = style_ == Style::Alias || (style_ != Style::Direct && style_ != Style::Condition &&
                                                  !names_by_phrase(style_) && rng_.chance(0.8));
    if (other)
      if (const auto others = lexicon_.synonyms(member.category); !others.empty()) name = rng_.pick(others);
    if (name.singular.empty()) return std::nullopt;
    // One opens the oven of a stove.
    const bool opened =
        std::find(wording_.opened.begin(), wording_.opened.end(), member.category) != wording_.opened.end();
    const auto oven = opened && (name.singular == "stove" || name.singular == "cooker")
                          ? lexicon_.noun_at(tokens_of("oven"), 0).nouns
                          : std::vector<Domain>();
    if (oven.size() == 1 && oven[0] == of_category(member.category)) name.singular = "oven", name.plural = "ovens";
    found = chosen_.emplace(member.category, name).first;
  }
  const NounTable::Name& name = found->second;
  countable = name.countable || member.slice;
  if (member.slice) {
    // Nobody speaks of a slice of these.
    for (const char* const several : {"slice of ", "bunch of ", "head of ", "piece of ", "ear of ", "sheet of "})
      if (name.singular.starts_with(several)) return std::nullopt;
    const std::string whole = as_sliced(name.singular);
    const std::string cut = whole == "lettuce" ? "piece" : "slice";
    const std::string fresh = may_mean_what_is_there(cut + " of " + whole) ? "freshly cut " : "";
    return fresh + cut + (plural ? "s of " : " of ") + whole;
  }
  return plural ? name.plural : name.singular;
}

bool Naming::is_plural(const Noun& noun) {
  return !noun.countable && noun.singular.ends_with('s') && !noun.singular.ends_with("ss");
}

bool Naming::is_countable(const Domain& noun) const {
  return std::all_of(noun.members.begin(), noun.members.end(), [&](const Domain::Member& member) {
    const auto* name = lexicon_.display(member.category);
    return member.slice || (name != nullptr && name->countable);
  });
}

/// The phrases that do not say the name of what they stand for.
std::vector<std::string> Naming::nameless(const Domain& noun, AliasKind use) const {
  auto phrases = lexicon_.phrases(noun, use);
  std::erase_if(phrases, [&](const std::string& phrase) {
    const auto words = tokens_of(phrase);
    return std::any_of(noun.members.begin(), noun.members.end(), [&](const Domain::Member& member) {
      const auto* name = lexicon_.display(member.category);
      return name != nullptr && (says(words, name->singular) || says(words, name->plural));
    });
  });
  return phrases;
}

std::vector<std::string> Naming::uses(const Domain& noun) const {
  if (noun.kind != Domain::Kind::Categories || style_ == Style::Alias) return {};
  if (style_ == Style::Context) return lexicon_.needs(noun);
  if (style_ == Style::Hypernym) return nameless(noun, AliasKind::Hypernym);
  if (style_ == Style::Description) return nameless(noun, AliasKind::Description);
  if (style_ == Style::Function) return nameless(noun, AliasKind::Function);
  if (noun.members.size() == 1) return {};
  for (const AliasKind use : {AliasKind::Hypernym, AliasKind::Function, AliasKind::Description})
    if (auto found = lexicon_.phrases(noun, use); !found.empty()) return found;
  constexpr std::size_t kMostListed = 4;  // "an apple, pear or plum"; more have no words but an occasion
  if (noun.members.size() <= kMostListed) return {};
  return lexicon_.needs(noun);
}

bool Naming::names_by_use(const Domain& noun) const {
  const auto named = uses(noun);
  return std::any_of(named.begin(), named.end(), [&](const std::string& use) {
    // "a vegetable for it", which nobody washes either without an occasion
    return !everyday() || use.starts_with("something ") || use.ends_with(" for it");
  });
}

std::optional<std::string> Naming::singular(const Domain& domain) {
  const auto bare = noun(domain, false);
  if (!bare || bare->function) return std::nullopt;
  return bare->singular;
}

std::optional<std::string> Naming::several(const Domain& domain) {
  auto one = is_countable(domain) ? singular(domain) : std::nullopt;
  if (one) several_.push_back(domain);
  return one;
}

/// "The red one", where the text said that there are several, or has named another.
bool Naming::is_one_again(const NounPhrase& phrase) const {
  if (style_ != Style::Ellipsis || phrase.modifiers.empty()) return false;
  return std::find(several_.begin(), several_.end(), phrase.noun) != several_.end() ||
         std::any_of(named_.begin(), named_.end(), [&](const Named& other) { return other.noun == phrase.noun; });
}

std::optional<Naming::Noun> Naming::noun(const Domain& domain, bool exact) {
  if (domain.kind == Domain::Kind::Object) return Noun{"object", "objects"};
  if (domain.kind == Domain::Kind::Room) return Noun{"room", "rooms"};
  if (domain.kind == Domain::Kind::Agent) return exact ? std::optional(Noun{"agent", "agents"}) : std::nullopt;
  if (const auto phrases = exact ? std::vector<std::string>() : uses(domain); !phrases.empty()) {
    const std::string text = rng_.pick(phrases);
    return Noun{text, text, true, true};
  }
  constexpr std::size_t kMostNamed = 4;  // nobody says "a dish or food tray or plate or platter or tray"
  if (everyday() && !exact && domain.members.size() > kMostNamed) return std::nullopt;
  Noun noun;
  for (const Domain::Member& member : domain.members) {
    bool countable = true;
    auto singular = name_of(member, false, countable), plural = name_of(member, true, countable);
    if (!singular || !plural) return std::nullopt;
    if (domain.members.size() > 1 && !countable) {
      plural = "pieces of " + *singular;
      singular->insert(0, "piece of ");
      countable = true;
    }
    noun.singular += (noun.singular.empty() ? "" : " or ") + *singular;
    noun.plural += (noun.plural.empty() ? "" : " or ") + *plural;
    noun.countable = countable;
  }
  return noun;
}

std::optional<std::string> Naming::plural(const NounPhrase& phrase, Place place) {
  if (!phrase.modifiers.empty()) return std::nullopt;
  const auto bare = noun(phrase.noun, place.exact);
  if (!bare || bare->function) return std::nullopt;
  if (place.exact) named_.push_back({phrase.variable, phrase.noun, false, ""});
  return bare->countable ? bare->plural : "pieces of " + bare->singular;
}

std::optional<std::string> Naming::complement(const Complement& said, Place place) {
  std::string text = said.negated ? "not " : "";
  const std::string symbol = said.symbol == "any" ? "something" : symbol_words(said.symbol);
  switch (said.predicate) {
    case Predicate::Filled:
      return text + "filled with " + symbol;
    case Predicate::Covered:
      return text + "covered with " + symbol;
    case Predicate::Material:
      return text + "made of " + symbol;
    case Predicate::Color:
      return text + (lexicon_.is_color(said.symbol) ? symbol : "of the colour " + symbol);
    case Predicate::Size:
      return text + "of the size " + symbol;
    default:
      break;
  }
  if (said.object.empty()) {
    const std::string word = state_word(said.predicate);
    return word.empty() ? std::nullopt : std::optional(text + word);
  }
  const auto object = phrase(said.object[0], place);
  const std::string preposition = before_object(said.predicate);
  if (!object || preposition.empty()) return std::nullopt;
  if (said.predicate == Predicate::OnFloor && !place.exact && (object->text == "it" || everyday()))
    return text + "on " + floor_of(object->text, !said.object[0].modifiers.empty());
  return text + preposition + " " + object->text;
}

std::optional<Words> Naming::phrase(const NounPhrase& said, Place place) {
  if (said.determiner == Determiner::Agent) return Words{"you", true};
  const auto bare = noun(said.noun, place.exact);
  if (!bare) return std::nullopt;
  if (!said.variable.empty() && was_named(said.variable)) return again(said, *bare, place);
  if (!said.variable.empty() && (place.inside_description || place.beside_none)) {
    if (!everyday() || !is_alone(said.noun) || !said.modifiers.empty()) return std::nullopt;
    mentioned_.push_back(said.variable);
    return Words{"the " + bare->singular};
  }
  if (said.except) return all_but(said, *bare);
  if (!said.done.empty() && said.done[0].predicate == Predicate::SliceOf) {
    if (topic_ != said.done[0].object[0].variable) return std::nullopt;
    mentioned_.push_back(said.variable);
    named_.push_back({said.variable, said.noun, false, ""});
    return Words{"one of the slices"};
  }
  // Nobody washes "something to drink from".
  if (everyday() && bare->function && bare->singular.starts_with("something ") && !place.sought &&
      style_ != Style::Context)
    return std::nullopt;
  if (bare->function && (said.determiner != Determiner::New || !said.modifiers.empty())) return std::nullopt;

  const auto description = describe(said, place);
  if (!description) return std::nullopt;
  if (place.exact && !place.inside_description) return bound(said, *bare, *description);
  if (said.determiner != Determiner::New) return counted(said, *bare, place, *description);
  return first(said, *bare, place, *description);
}

/// "every mug but the red one"
std::optional<Words> Naming::all_but(const NounPhrase& said, const Noun& noun) {
  if (said.determiner != Determiner::Every || !noun.countable || noun.function || said.there == 1) return std::nullopt;
  if (everyday() && !pair_name(said.noun, noun).empty()) return std::nullopt;  // "all the pants but the blue one"
  const auto left = describe(said, {});
  if (!left) return std::nullopt;
  NounPhrase all = said;
  all.except = all.two = false;
  all.there = 0;
  all.modifiers.clear();
  auto words = counted(all, noun, {}, {});
  if (words)
    words->text += pick({" but", " but", " except", " except for"}) + std::string(" the ") + left->before + "one" +
                   left->tail(false);
  return words;
}

std::optional<Words> Naming::bound(const NounPhrase& said, const Noun& noun, const Description& description) {
  named_.push_back({said.variable, said.noun, said.noun.kind == Domain::Kind::Object, ""});
  const std::string one = description.before + (noun.countable ? noun.singular : "piece of " + noun.singular);
  if (said.determiner == Determiner::New) return Words{"some " + one + description.tail(false)};
  if (said.determiner == Determiner::Every) return Words{pick({"every", "each"}) + " " + one + description.tail(false)};
  return counted(said, noun, {}, description);
}

/// What was named last, and, of what is put somewhere, what was spoken of: "put the mug in the box and put it …" could
/// be either.
bool Naming::is_what_it_means(const NounPhrase& said, Place place) const {
  if (place.exact || place.inside_description || clause_ == 0) return false;
  if (everyday() && topic_ == said.variable) return true;  // "put the lamp on the desk and turn it on"
  return mentioned_[clause_ - 1] == said.variable && (!place.moved || topic_ == said.variable || named_.size() == 1);
}

std::optional<Words> Naming::again(const NounPhrase& said, const Noun& noun, Place place) {
  std::vector<std::size_t> alike;
  std::size_t position = 0;
  const bool vague = noun.function;
  std::string use;
  for (const Named& other : named_) {
    if (other.variable == said.variable) position = alike.size(), use = other.use;
    if (other.noun == said.noun) alike.push_back(alike.size());
  }
  // "Before you put the ketchup in the fridge, put the mustard in it" could mean the ketchup.
  const bool either = everyday() && style_ == Style::InvertedOrder && !place.moved && topic_ != said.variable;
  const bool clear = is_what_it_means(said, place) && !either;
  mentioned_.push_back(said.variable);
  const double usual = everyday() ? wording_.pronouns : named_.size() > 1 ? 0 : style_ == Style::Anaphora ? 1 : 0.7;
  const std::string pair = everyday() ? pair_name(said.noun, noun) : "";
  const bool several = is_plural(noun) || !pair.empty();
  if (clear && rng_.chance(usual)) return several ? Words{"them", true} : Words{"it"};
  if (everyday() && vague) return std::nullopt;
  // "That object" is clear only where no other was named: "that thing to drink from".
  const std::string word = !vague ? noun.singular : named_.size() == 1 ? "object" : named_again(use);
  if (word.empty()) return std::nullopt;
  if (alike.size() > 1) {
    static constexpr std::array kOrdinals{"first",   "second", "third", "fourth", "fifth",    "sixth",
                                          "seventh", "eighth", "ninth", "tenth",  "eleventh", "twelfth"};
    if (vague || position >= kOrdinals.size() || (!place.exact && (position > 2 || !noun.countable)))
      return std::nullopt;
    return Words{"the " + std::string(kOrdinals[position]) + (noun.countable ? " " : " piece of ") + word};
  }
  if (place.exact) return Words{(place.inside_description ? "that " : "the ") + word};
  if (everyday() && !vague) return Words{"the " + (pair.empty() ? word : pair), several};
  const std::string article =
      vague || noun.countable ? pick({"that", "that", "the same", "the"}) : pick({"that", "the same"});
  return Words{article + " " + word};
}

std::optional<Words> Naming::first(const NounPhrase& said, const Noun& noun, Place place,
                                   const Description& description) {
  const std::string& before = description.before;
  std::size_t alike = 0, distinct = 0;
  for (const Named& other : named_) {
    if (other.noun != said.noun) continue;
    ++alike;
    distinct += plan_.distinct.contains({other.variable, said.variable}) ? 1 : 0;
  }
  if (!said.variable.empty() && distinct != 0 && distinct != alike) return std::nullopt;
  const std::string tail = description.tail(false);
  const bool another = distinct > 0;
  const bool again_one = noun.countable && !noun.function && is_one_again(said);
  // Inside a description the object is any of its kind and stays unnamed.
  if (!said.variable.empty()) mentioned_.push_back(said.variable);
  if (!said.variable.empty())
    named_.push_back({said.variable, said.noun, noun.function || said.noun.kind == Domain::Kind::Object,
                      noun.function ? noun.singular : ""});
  // "All the plates on something to sit on" could be several.
  const bool unclear = another || (place.beside_every && !noun.singular.starts_with("the "));
  if (noun.function) return unclear ? std::nullopt : std::optional(Words{noun.singular});
  if (again_one) return Words{"the " + before + "one" + tail};
  if (description.of_two) return Words{"the " + before + "of the two " + noun.plural + tail};
  if (everyday() && !another) return first_everyday(said, noun, place, description);
  if (another && everyday() && place.moved && said.modifiers.empty() && noun.countable) {
    const auto last =
        std::find_if(named_.begin(), named_.end(), [&](const Named& one) { return one.variable == topic_; });
    if (last != named_.end() && last->noun == said.noun) return Words{said.there == 2 ? "the other" : "another"};
  }
  if (another) {
    const std::string word = before + (noun.countable ? noun.singular : "piece of " + noun.singular);
    return Words{(everyday() || rng_.chance(0.7) ? "another " : "a different ") + word + tail};
  }
  if (!noun.countable) {
    if (place.beside_every) return Words{"a single " + before + "piece of " + noun.singular + tail};
    const bool marked = !said.modifiers.empty() && !place.wanted && rng_.chance(0.9);
    return Words{(marked ? "the " : "some ") + before + noun.singular + tail};
  }
  // What is described is meant alone: "the mug nearest to the sink", not one of several.
  const bool described = !said.modifiers.empty() && !place.wanted;
  if (described && !place.inside_description && rng_.chance(0.97)) return Words{"the " + before + noun.singular + tail};
  if (place.beside_every)
    return Words{pick({"one", "a single", "one and the same"}) + " " + before + noun.singular + tail};
  if (place.unique) return Words{"the " + before + noun.singular + tail};
  if (place.inside_description && rng_.chance(0.7)) return Words{with_article(before + noun.singular) + tail};
  const bool room = !said.noun.members.empty() && lexicon_.is_room_type(said.noun.members[0].category);
  // "The mug" would promise that there is one only; of rooms there mostly is.
  if (room && alike == 0 && !place.chosen && rng_.chance(0.7)) return Words{"the " + before + noun.singular + tail};
  if (rng_.chance(0.25)) return Words{"one " + before + noun.singular + tail};
  return Words{with_article(before + noun.singular) + tail};
}

std::optional<Words> Naming::counted(const NounPhrase& said, const Noun& noun, Place place,
                                     const Description& description) {
  const std::string& before = description.before;
  bool plural = false;
  const std::string one = before + (noun.countable ? noun.singular : "piece of " + noun.singular);
  const std::string many = before + (noun.countable ? noun.plural : "pieces of " + noun.singular);
  const std::string number = number_word(said.number);
  std::string text;
  plural = said.number != 1;
  const bool the = everyday() && said.there == 1;
  counted_.push_back(said.noun);
  if (the && (said.determiner == Determiner::Every || said.determiner == Determiner::Any)) {
    mentioned_.emplace_back();
    const std::string pair = pair_name(said.noun, noun);
    const bool several = is_plural(noun) || !pair.empty();
    return Words{"the " + before + (pair.empty() ? noun.singular : pair) + description.tail(several), several};
  }
  switch (said.determiner) {
    case Determiner::Any:
      plural = false;
      mentioned_.emplace_back();
      if (everyday() && is_alone(said.noun) && said.modifiers.empty()) return Words{"the " + noun.singular};
      if (!noun.countable) return std::nullopt;
      if (everyday() && place.beside_every && said.modifiers.empty()) return Words{"the " + many, true};
      text = "any " + one;
      break;
    case Determiner::Every:
      plural = rng_.chance(0.5) || place.together;
      if (!noun.countable) {
        plural = is_plural(noun);
        text = "all the " + before + noun.singular;
      } else {
        plural = plural || (everyday() && rng_.chance(0.5));
        const std::string all = everyday() ? "all the" : pick({"all", "all the", "all of the"});
        text = plural ? all + " " + many : (everyday() ? "every" : pick({"every", "each"})) + " " + one;
      }
      if (const std::string pair = everyday() ? pair_name(said.noun, noun) : ""; !pair.empty()) {
        plural = true;
        text = "all the " + before + pair;
      }
      if (said.two && noun.countable && (everyday() || rng_.chance(0.8))) {
        plural = true;
        text = (everyday() ? "both" : pick({"both", "both", "both of the"})) + " " + many;
      }
      break;
    case Determiner::No:
      plural = noun.countable && rng_.chance(0.4);
      text = "no " + (plural ? many : before + noun.singular);
      break;
    case Determiner::Exactly:
      if (everyday() && !place.exact && said.number > 0)
        text = (said.number == 1 ? "just " : "") + number;
      else
        text = pick({"exactly ", "exactly ", "precisely "}) + number;
      break;
    case Determiner::AtLeast:
      if ((style_ == Style::VagueQuantity || (everyday() && !place.exact)) && noun.countable &&
          (said.number == 2 || said.number == 3))
        return Words{(said.number == 2 ? "a couple of " : "a few ") + many + description.tail(true), true};
      text = (everyday() ? "at least " : pick({"at least ", "no fewer than "})) + number;
      break;
    case Determiner::AtMost:
      text = pick({"at most ", "no more than "}) + number;
      break;
    default:
      return std::nullopt;
  }
  if (said.determiner == Determiner::Exactly || said.determiner == Determiner::AtLeast ||
      said.determiner == Determiner::AtMost) {
    // "two of the mugs": there are more that the description picks out.
    const bool of_the = noun.countable && !said.modifiers.empty() && rng_.chance(0.5);
    text += of_the ? " of the " + many : " " + (plural ? many : one);
    plural = plural || of_the;
  }
  return Words{text + description.tail(plural), plural};
}

}  // namespace unietp
