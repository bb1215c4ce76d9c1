#include "annotator/authored.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "annotator/phrase_plan.h"
#include "annotator/realize.h"
#include "annotator/words_for_writing.h"
#include "core/text.h"
#include "templates/phrasing.h"

namespace unietp {
namespace {

using Op = Formula::Op;
using Text = std::optional<std::string>;

/// After which something may be named by its use alone.
constexpr std::array<std::string_view, 5> kFetches{"get ", "fetch ", "grab ", "bring ", "find "};

/// Words that go with one thing.
constexpr std::array<std::string_view, 6> kOfOne{"it", "is", "has", "belongs", "goes", "one"};

/// "Turn on it" → "Turn it on". Verbs lack their first letter, which may be a capital.
std::string with_it_before_particles(std::string text) {
  for (const char* const verb : {"urn", "witch", "eat", "arm", "ick", "ool", "lug"})
    for (const char* const particle : {"on", "off", "up", "down", "in"})
      text = replace_all(text, join({verb, particle, "it"}, " "), join({verb, "it", particle}, " "));
  return text;
}

class Author {
 public:
  Author(const Specification& specification, const NounTable& lexicon, const Wording& wording, const HomeCounts& home,
         Rng rng)
      : specification_(specification),
        lexicon_(lexicon),
        style_(wording.style),
        rng_(rng),
        naming_(plan_, lexicon, wording, rng_),
        home_(home),
        phrases_(specification.init, home) {
    for (const Formula* f = &specification.goal; f->op == Op::Exists; f = &f->children[0])
      phrases_.scope()[f->variable] = f->domain;
  }

  Text text(std::string_view phrasing) {
    const auto reading = read_slots(phrasing);
    if (!reading.errors.empty()) return std::nullopt;
    std::string filled;
    if (style_ == Style::Anaphora) {
      const Text fact = opening_fact();
      if (!fact) return std::nullopt;
      filled = *fact + " ";
    }
    const std::size_t begin = filled.size();
    another_ = phrasing.find(" another ") != phrasing.npos;
    const auto words = tokens_of(phrasing);
    speaks_of_one_ = std::any_of(words.begin(), words.end(), [](const Token& word) {
      return std::find(kOfOne.begin(), kOfOne.end(), word.text) != kOfOne.end();
    });
    says_the_one_ = phrasing.find("eave the one ") != phrasing.npos;
    std::size_t at = 0;
    for (const Slot& slot : reading.slots) {
      const std::string_view before = phrasing.substr(at, slot.offset - at);
      filled += before;
      at = slot.offset + slot.length;
      naming_.begin_clause();
      const Place place{.beside_the = lists_the(reading.slots, slot, phrasing),
                        .sought = is_fetched(before),
                        .moved = goes_somewhere(reading.slots, slot, phrasing)};
      is_listed_ = &slot != &reading.slots.back() && goes_on(slot, *(&slot + 1), phrasing);
      const Text said = words_for(slot, before, place);
      if (!said || phrases_.error()) return std::nullopt;
      filled += *said;
      if (&slot == &reading.slots.front()) naming_.set_topic(lower(slot.placeholder));
    }
    filled += phrasing.substr(at);
    // "Take the mug that is on the desk": people take it off the desk.
    if (filled.starts_with("Take ") &&
        (filled.find(" that is ") != filled.npos || filled.find(" that's ") != filled.npos))
      return std::nullopt;
    filled = with_everyday_floors(std::move(filled));
    filled = with_it_before_particles(std::move(filled));
    if (begin < filled.size())
      filled[begin] = static_cast<char>(std::toupper(static_cast<unsigned char>(filled[begin])));
    return filled;
  }

 private:
  /// "the floor of the kitchen" → "the kitchen floor".
  std::string with_everyday_floors(std::string text) const {
    for (const auto& [variable, domain] : phrases_.scope()) {
      const NounTable::Name* room = domain.members.size() == 1 ? lexicon_.display(domain.members[0].category) : nullptr;
      if (room == nullptr) continue;
      for (const std::string article : {"the ", "a "}) {
        const std::string named = article + room->singular;
        text = replace_all(text, "the floor of " + named, floor_of(named, !domain.where.empty()));
      }
    }
    return text;
  }

  /// "There is a mug on the desk.", of the thing that the goal describes.
  Text opening_fact() {
    for (const auto& [variable, domain] : phrases_.scope()) {
      if (domain.where.empty()) continue;
      return fact_sentence(phrases_.reference(variable, specification_.goal), naming_, rng_);
    }
    return std::nullopt;
  }

  /// "Get something to drink from": nobody washes such a thing.
  static bool is_fetched(std::string_view before) {
    return std::any_of(kFetches.begin(), kFetches.end(),
                       [&](std::string_view verb) { return lower(before).ends_with(verb); });
  }

  /// Whether a place or another thing follows: "put {A} {B:on}", "put {A} and {B} {C:on}".
  static bool goes_somewhere(const std::vector<Slot>& slots, const Slot& slot, std::string_view phrasing) {
    if (&slot == &slots.back()) return false;
    const std::size_t end = slot.offset + slot.length;
    const std::string_view link = phrasing.substr(end, (&slot + 1)->offset - end);
    return link == " " || link == ", " || link == " and ";
  }

  /// Whether two slots follow one another in a list.
  static bool goes_on(const Slot& one, const Slot& next, std::string_view phrasing) {
    const std::size_t end = one.offset + one.length;
    const std::string_view link = phrasing.substr(end, next.offset - end);
    return link == ", " || link == " and ";
  }

  /// Whether a slot is in a list, "{A}, {B} and {C}", with what there is one of.
  bool lists_the(const std::vector<Slot>& slots, const Slot& slot, std::string_view phrasing) {
    const auto is_the = [&](const Slot& one) {
      const auto found = phrases_.scope().find(lower(one.placeholder));
      return found != phrases_.scope().end() &&
             naming_.will_be_the(phrases_.reference(found->first, specification_.goal));
    };
    const std::size_t at = static_cast<std::size_t>(&slot - slots.data());
    std::size_t from = at, to = at;
    while (from > 0 && goes_on(slots[from - 1], slots[from], phrasing)) --from;
    while (to + 1 < slots.size() && goes_on(slots[to], slots[to + 1], phrasing)) ++to;
    return std::any_of(slots.begin() + static_cast<std::ptrdiff_t>(from),
                       slots.begin() + static_cast<std::ptrdiff_t>(to) + 1, is_the);
  }

  std::string category_of(const std::string& placeholder) const {
    for (const auto& [name, category] : specification_.binding)
      if (name == placeholder) return category;
    return "";
  }

  static const Formula* binder_of_slices(const Formula& part, const std::string& category) {
    const auto& members = part.domain.members;
    if (members.size() == 1 && members[0].slice && members[0].category == category) return &part;
    for (const Formula& child : part.children)
      if (const Formula* found = binder_of_slices(child, category)) return found;
    return nullptr;
  }

  /// Of a placeholder for a word or for what is sliced: "red", "wooden", "salt", "potato" of "two slices of potato".
  Text bound_word(const std::string& word, std::string_view before) {
    if (word.empty()) return std::nullopt;
    if (before.ends_with("slices of ")) return naming_.singular(of_category(word));
    const bool shaken = naming_.comes_from_a_shaker(word);
    if (before.ends_with("prinkle ") && !shaken) return std::nullopt;
    if (before.ends_with("rizzle ") && !is_drizzled(word)) return std::nullopt;
    if (before.ends_with("pread ") && (shaken || is_drizzled(word))) return std::nullopt;
    return before.ends_with("the ") && word == "wood" ? "wooden" : symbol_words(word);
  }

  Text words_for(const Slot& slot, std::string_view before, Place place) {
    const std::string category = category_of(slot.placeholder);
    const Formula* binder = slot.form == SlotForm::Slice ? binder_of_slices(specification_.goal, category)
                                                         : binder_of(specification_.goal, lower(slot.placeholder));
    if (binder == nullptr) return slot.form == SlotForm::Bare ? bound_word(category, before) : std::nullopt;
    const std::string& variable = binder->variable;
    if (slot.form == SlotForm::Bare || slot.form == SlotForm::Plural) {
      // "In the same fridge", of a home with one.
      if (before.ends_with("same ") && naming_.is_alone(binder->domain)) return std::nullopt;
      return bare(*binder, slot.form == SlotForm::Plural, before);
    }
    const bool whole = phrases_.scope().contains(variable);
    if (another_ && home_.members(binder->domain, variable).size() == 2) return std::nullopt;  // "the other"
    NounPhrase thing;
    if (whole) {
      thing = phrases_.reference(variable, specification_.goal);
    } else {
      thing.noun = binder->domain;
      thing.noun.where.clear();
      thing.there = home_.members(binder->domain, variable).size();
    }
    // What is put somewhere is not described by another place: "put the mug that is on the desk on the shelf".
    if (place.moved && !naming_.was_named(variable) &&
        std::any_of(thing.modifiers.begin(), thing.modifiers.end(), describes_by_place))
      return std::nullopt;
    // "The book nearest to the couch and the magazine" is nearest to both.
    if (is_listed_ && !naming_.was_named(variable) && !thing.modifiers.empty() &&
        !thing.modifiers.back().object.empty())
      return std::nullopt;
    // "Some bread. Leave the one on the table …"
    if (says_the_one_ && slot.form == SlotForm::Indefinite && !naming_.is_countable(thing.noun)) return std::nullopt;
    if (slot.form == SlotForm::Slice && !of_slices(thing.noun)) return std::nullopt;
    const bool closed = before.ends_with("Close ") || before.ends_with("close ") || before.ends_with("shut ");
    if (closed && naming_.has_lid(thing.noun)) return std::nullopt;
    if (before.ends_with("lid on ") && !naming_.has_lid(thing.noun)) return std::nullopt;
    if (before.ends_with(" water ") && !naming_.is_plant(thing.noun)) return std::nullopt;
    if (before.ends_with("pour it into ") && naming_.is_plant(thing.noun)) return std::nullopt;
    place.inside_description = !whole;
    place.beside_every = said_all_ && whole;
    const auto named = naming_.phrase(thing, place);
    if (!named) return std::nullopt;
    const bool several = named->plural || named->text.find("pair of ") != std::string::npos;  // "them"
    if (several && speaks_of_one_) return std::nullopt;
    const bool article =
        slot.form == SlotForm::Indefinite || slot.form == SlotForm::Definite || slot.form == SlotForm::Slice;
    if (article) return named->text;
    const std::string_view preposition = slot.form == SlotForm::Inside ? "in" : name_of(slot.form);
    return replace_all(std::string(preposition), "-", " ") + " " + named->text;
  }

  /// The noun alone, to which the phrasing adds what it wants.
  Text bare(const Formula& binder, bool plural, std::string_view before) {
    if (binder.op == Op::Forall || binder.op == Op::Count) {
      const std::size_t there = home_.members(binder.domain, binder.variable).size();
      // "All the mugs" and "two mugs" promise more; of two it would be "both".
      const bool takes_all = binder.number == 0;  // "take both mugs off the table"
      const bool all = binder.op == Op::Forall || takes_all || static_cast<int>(there) == binder.number;
      const bool says_both = before.ends_with("oth ");
      const bool one_of = before.ends_with("One of the ") || before.ends_with("one of the ");  // "… and the other one"
      if (one_of ? there != 2 : there == 1 || (there == 2 && all) != says_both) return std::nullopt;
      if (there > 0 && static_cast<int>(there) == binder.number && !says_both && !one_of) return std::nullopt;
      said_all_ = said_all_ || (binder.op == Op::Forall && !before.ends_with("ne of the "));
    }
    NounPhrase thing;
    thing.noun = binder.domain;
    thing.noun.where.clear();
    if (plural) {
      const Text many = naming_.plural(thing);
      const bool all = before.ends_with("the ") && !before.ends_with("ne of the ");
      return many && all && many->starts_with("pairs of ") ? std::nullopt : many;  // "all the pants"
    }
    // "A warm macaroni and cheese"
    const bool counts_one = before.ends_with(" a ") || before.ends_with(" a warm ") || before.ends_with(" a cold ");
    if (counts_one && !naming_.is_countable(thing.noun)) return std::nullopt;
    const Text one = naming_.singular(thing.noun);
    return one && one->starts_with("pair of ") ? std::nullopt : one;  // "the pants that are on the chair"
  }

  static bool of_slices(const Domain& noun) {
    return std::all_of(noun.members.begin(), noun.members.end(), [](const auto& member) { return member.slice; });
  }

  const Specification& specification_;
  const NounTable& lexicon_;
  bool speaks_of_one_ = false;  // "the pants" would not go with "it"
  bool says_the_one_ = false;   // the phrasing speaks of "the one" that stays
  bool another_ = false;        // the phrasing speaks of another
  bool said_all_ = false;       // "all the mugs" came before
  bool is_listed_ = false;      // another thing of a list follows
  Style style_;
  Rng rng_;
  Plan plan_;
  Naming naming_;
  HomeCounts home_;
  PhrasePlanner phrases_;
};

}  // namespace

std::optional<std::string> authored_text(std::string_view phrasing, const Specification& specification,
                                         const NounTable& lexicon, const Wording& wording, const HomeCounts& home,
                                         Rng rng) {
  return Author(specification, lexicon, wording, home, rng).text(phrasing);
}

}  // namespace unietp
