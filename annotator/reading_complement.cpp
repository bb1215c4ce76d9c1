#include <algorithm>
#include <array>

#include "annotator/reading.h"
#include "annotator/words_for_reading.h"
#include "core/text.h"

namespace unietp {
namespace {

using P = Predicate;

constexpr std::array<std::string_view, 6> kLarge{"large", "larger", "largest", "big", "bigger", "biggest"};
constexpr std::array<std::string_view, 3> kSmall{"small", "smaller", "smallest"};

}  // namespace

std::optional<Complement> PhraseReader::adjective() const {
  for (const PredicatePhrase& state : state_phrases())
    if (peek() == state.words) return Complement{state.predicate, false, "", {}};
  if (lexicon_.is_color(peek())) return Complement{P::Color, false, peek(), {}};
  if (peek() == "wooden") return Complement{P::Material, false, "wood", {}};
  if (lexicon_.is_material(peek())) return Complement{P::Material, false, peek(), {}};
  if (std::find(kLarge.begin(), kLarge.end(), peek()) != kLarge.end()) return Complement{P::Size, false, "large", {}};
  if (std::find(kSmall.begin(), kSmall.end(), peek()) != kSmall.end()) return Complement{P::Size, false, "small", {}};
  return std::nullopt;
}

/// "If the stove is on, …"
std::optional<Predicate> PhraseReader::on_or_off() const {
  if (peek(1) != "," && peek(1) != ".") return std::nullopt;
  return peek() == "on" ? std::optional(P::PowerOn) : peek() == "off" ? std::optional(P::PowerOff) : std::nullopt;
}

bool PhraseReader::complement_comes() const {
  if (comes("there , too")) return true;
  if (lexicon_.where_at(tokens_, at_).length > 0) return true;
  if (on_or_off()) return true;
  if (peek() == "not" || lexicon_.is_color(peek())) return true;
  for (const PredicatePhrase& words : state_phrases())
    if (comes(words.words)) return true;
  for (const PredicatePhrase& words : preposition_phrases())
    if (comes(words.words)) return true;
  const auto symbols = symbol_phrases();
  return std::any_of(symbols.begin(), symbols.end(), [&](const PredicatePhrase& words) { return comes(words.words); });
}

std::optional<Predicate> PhraseReader::preposition() {
  for (const PredicatePhrase& words : preposition_phrases())
    if (accept(words.words)) return words.predicate;
  return std::nullopt;
}

/// "the bedroom floor", "its floor": the room.
std::optional<NounPhrase> PhraseReader::room_floor() {
  if (accept("its floor")) {
    NounPhrase room;
    room.determiner = Determiner::It;
    room.column = column();
    return room;
  }
  if (peek() != "the" && peek() != "a" && peek() != "an") return std::nullopt;
  const auto room = lexicon_.room_at(tokens_, at_ + 1);
  if (room.length == 0 || peek(1 + room.length) != "floor") return std::nullopt;
  NounPhrase read = phrase();
  accept("floor");
  return read;
}

Complement PhraseReader::relation(Predicate predicate) {
  Complement read;
  read.predicate = predicate;
  read.object.push_back(place());
  const Domain& noun = read.object[0].noun;
  const bool room =
      noun.kind == Domain::Kind::Room || (!noun.members.empty() && lexicon_.is_room_type(noun.members[0].category));
  if (room && predicate == P::Inside) read.predicate = P::InRoom;
  return read;
}

Complement PhraseReader::complement() {
  if (accept("not")) {
    Complement read = complement();
    read.negated = !read.negated;
    return read;
  }
  if (put_last_ && accept(put_last_->predicate == P::Inside ? "in there , too" : "there , too")) return *put_last_;
  if (const auto where = lexicon_.where_at(tokens_, at_); where.length > 0) {  // "where we wash our hands"
    NounPhrase place;
    place.noun = where.nouns.front();
    place.by_function = true;
    place.column = column();
    at_ += where.length;
    return {choices_.choose(2) == 0 ? P::On : P::Inside, false, "", {std::move(place)}};
  }
  if (const auto power = on_or_off()) {
    ++at_;
    return {*power, false, "", {}};
  }
  for (const PredicatePhrase& words : state_phrases())
    if (accept(words.words)) return {words.predicate, false, "", {}};
  for (const PredicatePhrase& words : symbol_phrases())
    if (accept(words.words)) return {words.predicate, false, symbol(), {}};
  if (lexicon_.is_color(peek())) return {P::Color, false, tokens_[at_++].text, {}};
  if (comes("on")) {
    const std::size_t here = at_++;
    if (auto room = room_floor()) return {P::OnFloor, false, "", {*std::move(room)}};
    at_ = here;
  }
  if (const auto predicate = preposition()) return relation(*predicate);
  fail("expected a state or a place, such as 'clean' or 'on a table'");
  return {};
}

void PhraseReader::complements(Clause& into) {
  const bool either = accept("either");
  into.complements.push_back(complement());
  while (!failed()) {
    const std::size_t here = at_;
    if (comes(", not the")) break;  // "…, not the blue one" is of the thing
    const bool comma = accept(",");
    const bool alternative = accept("or");
    if ((!alternative && !accept("and") && !(comma && comma_lists_)) || !complement_comes()) {
      at_ = here;
      break;
    }
    into.any_complement |= alternative;
    into.complements.push_back(complement());
  }
  if (either && !into.any_complement) fail("expected 'or' after 'either'");
  exception(into);
}

std::string PhraseReader::symbol() {
  std::vector<std::string> words;
  while (!done() && !failed()) {
    bool stop = false;
    for (const char* end : {",",  ".",    "?",    "!",   ";",    "and", "or",    "before", "until", "then", "on",
                            "in", "into", "over", "off", "from", "at",  "again", "the",    "is",    "if",   "except"})
      stop |= peek() == end;
    if (stop) break;
    words.push_back(peek());
    ++at_;
  }
  if (words.empty()) fail("expected a substance");
  if (words.size() == 1 && words[0] == "something") return "any";
  if (words.size() > 1 && words.back() == "seeds") words.back() = "seed";
  return join(words, "_");
}

}  // namespace unietp
