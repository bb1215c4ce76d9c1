// How a noun phrase begins: which things of a kind it is about, and how many.
#include <algorithm>
#include <array>
#include <utility>

#include "annotator/reading.h"

namespace unietp {
namespace {

constexpr std::array<std::string_view, 13> kNumbers{"zero",  "one",   "two",  "three", "four",   "five",  "six",
                                                    "seven", "eight", "nine", "ten",   "eleven", "twelve"};

constexpr std::array<std::string_view, 12> kOrdinals{"first",   "second", "third", "fourth", "fifth",    "sixth",
                                                     "seventh", "eighth", "ninth", "tenth",  "eleventh", "twelfth"};

constexpr std::array<std::pair<std::string_view, std::string_view>, 3> kOfTwo = {
    {{"the larger of the two", "large"}, {"the bigger of the two", "large"}, {"the smaller of the two", "small"}}};

constexpr std::pair<Determiner, std::string_view> kCounts[] = {
    {Determiner::Exactly, "exactly"},       {Determiner::Exactly, "precisely"}, {Determiner::AtLeast, "at least"},
    {Determiner::AtLeast, "no fewer than"}, {Determiner::AtMost, "at most"},    {Determiner::AtMost, "no more than"}};

std::optional<int> number_in(const std::string& word) {
  const auto found = std::find(kNumbers.begin(), kNumbers.end(), word);
  if (found != kNumbers.end()) return static_cast<int>(found - kNumbers.begin());
  if (word.empty() || word.size() > 4 ||
      !std::all_of(word.begin(), word.end(), [](char c) { return c >= '0' && c <= '9'; }))
    return std::nullopt;
  return std::stoi(word);
}

}  // namespace

bool PhraseReader::phrase_comes() const {
  for (const char* start : {"a",    "an", "one",     "the",       "that", "some",    "any",    "every", "each", "all",
                            "both", "no", "exactly", "precisely", "just", "another", "enough", "it",    "them", "you"})
    if (peek() == start) return true;
  if (number_in(peek())) return true;
  for (const char* start : {"at least", "at most"})
    if (comes(start)) return number_in(peek(2)).has_value();
  return (occasion_ && comes(need_)) || comes("no fewer than") || comes("no more than") ||
         lexicon_.function_at(tokens_, at_).length > 0;
}

int PhraseReader::number() {
  const auto number = failed() ? std::nullopt : number_in(peek());
  if (!number) fail("expected a number");
  if (number) ++at_;
  return number.value_or(0);
}

NounPhrase PhraseReader::phrase() {
  NounPhrase read;
  read.column = column();
  if (failed() || phrase_without_noun(read)) return read;
  for (const auto kind : {&PhraseReader::single_phrase, &PhraseReader::referring_phrase,
                          &PhraseReader::quantified_phrase, &PhraseReader::counted_phrase})
    if (auto found = (this->*kind)(read)) return std::move(*found);
  fail("expected an object, such as 'a mug' or 'every plate'");
  return read;
}

NounPhrase PhraseReader::noun_with(NounPhrase phrase, Determiner determiner, bool plural) {
  phrase.determiner = determiner;
  return noun_after(std::move(phrase), plural);
}

/// "you", "it", "something to drink from", "what I need for that", "a slice of it", "that thing to drink from".
bool PhraseReader::phrase_without_noun(NounPhrase& read) {
  if (accept("you")) {
    read.determiner = Determiner::Agent;
    return true;
  }
  if (needed_for_occasion(read)) return true;
  // "a light switch" is no light, and "a toy" is what is called so where something is.
  const std::size_t named =
      comes("a") || comes("an") || comes("the") ? lexicon_.noun_at(tokens_, at_ + 1).length + 1 : 0;
  if (const auto function = lexicon_.function_at(tokens_, at_); function.length > named) {
    at_ += function.length;
    read.noun = function.nouns.front();
    read.by_function = true;
    return true;
  }
  if (slice_of_it(read)) return true;
  if (accept_one({"it", "them"}) >= 0) {
    read.determiner = Determiner::It;
    return true;
  }
  for (const auto& [article, length] : {std::pair{"that", 1U}, std::pair{"the same", 2U}, std::pair{"the", 1U}}) {
    const auto use = comes(article) ? lexicon_.function_again_at(tokens_, at_ + length) : NounTable::Reading{};
    if (use.length <= lexicon_.noun_at(tokens_, at_ + length).length) continue;
    at_ += length + use.length;
    read.determiner = Determiner::Known;
    read.noun = use.nouns.front();
    return true;
  }
  return false;
}

/// "the second mug", "a single mug", "one of the mugs", "one mug".
std::optional<NounPhrase> PhraseReader::single_phrase(NounPhrase read) {
  const auto ordinal = peek() == "the" ? std::find(kOrdinals.begin(), kOrdinals.end(), peek(1)) : kOrdinals.end();
  if (ordinal != kOrdinals.end() && lexicon_.noun_at(tokens_, at_ + 2).length > 0) {
    at_ += 2;
    read.number = static_cast<int>(ordinal - kOrdinals.begin()) + 1;
    return noun_with(read, Determiner::Ordinal);
  }
  // "a single bed" is one bed, unless there is a category "single bed".
  const bool single_in_name = peek(1) == "single" && lexicon_.noun_at(tokens_, at_ + 1).length > 0;
  if (!single_in_name && accept_one({"a single", "one single"}) >= 0) return noun_with(read, Determiner::Single);
  if (accept("one of the")) return noun_with(read, Determiner::Single, true);
  if (accept_one({"one and the same", "one"}) >= 0) return noun_with(read, Determiner::Single);
  return std::nullopt;
}

/// "the same mug", "that mug", "another mug", "the other", "the larger of the two mugs", "the mug".
std::optional<NounPhrase> PhraseReader::referring_phrase(NounPhrase read) {
  if (accept("the same")) {
    const std::vector<Domain> before = named_;
    read = noun_with(read, Determiner::Known);
    // "Put both mugs in the same cabinet."
    if (std::find(before.begin(), before.end(), read.noun) == before.end()) read.determiner = Determiner::Single;
    return read;
  }
  if (accept("that")) return noun_with(read, Determiner::Known);
  if (accept_one({"another", "a different"}) >= 0) {
    if (!moved_ || lexicon_.noun_at(tokens_, at_).length > 0 || !complement_comes())
      return noun_with(read, Determiner::Another);
    read.determiner = Determiner::Another;  // "put a mug on the table and another on the shelf"
    read.noun = *moved_;
    return read;
  }
  if (comes("the other") && moved_ && lexicon_.noun_at(tokens_, at_ + 2).length == 0 && accept("the other")) {
    read.determiner = Determiner::Another;  // "put one mug on the table and the other on the shelf": there are two
    read.noun = *moved_;
    read.promised = 2;
    return read;
  }
  for (const auto& [words, size] : kOfTwo) {
    if (!accept(words)) continue;
    read.modifiers.push_back({Predicate::Size, false, std::string(size), {}});
    return noun_with(read, Determiner::The, true);
  }
  if (accept("the")) return noun_with(read, Determiner::The);
  return std::nullopt;
}

/// "a few mugs", "a mug", "any mug", "some mug or other", "every mug", "all mugs", "both mugs".
std::optional<NounPhrase> PhraseReader::quantified_phrase(NounPhrase read) {
  for (const auto& [words, number] : {std::pair{"a couple of", 2}, std::pair{"a few", 3}, std::pair{"enough", 2}}) {
    if (!accept(words)) continue;
    read.number = number;
    return noun_with(read, Determiner::AtLeast, true);
  }
  if (accept_one({"an", "a"}) >= 0) return noun_with(read, Determiner::New);
  if (accept("any")) return noun_with(read, Determiner::Any);
  if (accept("some")) {  // "some bread" is a mass, "some mug or other" any
    read = noun_with(read, Determiner::New);
    if (accept("or other")) read.determiner = Determiner::Any;
    return read;
  }
  if (accept("each of the")) return noun_with(read, Determiner::Every, true);
  if (accept_one({"every", "each"}) >= 0) return noun_with(read, Determiner::Every);
  if (accept_one({"all of the", "all the", "all"}) >= 0) return noun_with(read, Determiner::Every, true);
  if (accept_one({"both of the", "both the", "both"}) >= 0) {
    read.promised = 2;
    return noun_with(read, Determiner::Every, true);
  }
  return std::nullopt;
}

/// "at least two mugs", "exactly one of the mugs", "just two mugs", "no mug".
std::optional<NounPhrase> PhraseReader::counted_phrase(NounPhrase read) {
  for (const auto& [determiner, words] : kCounts) {
    if (!accept(words)) continue;
    read.number = number();
    if (failed()) return std::nullopt;
    const bool of_the = accept("of the");  // "one of the mugs"
    return noun_with(read, determiner, of_the || read.number != 1);
  }
  accept("just");
  if (const auto number = number_in(peek()); number && *number > 0) {
    ++at_;
    read.number = *number;
    return noun_with(read, Determiner::Exactly, *number != 1);
  }
  if (accept("no")) {
    const auto noun = lexicon_.noun_at(tokens_, at_);
    return noun_with(read, Determiner::No, noun.plural && !noun.singular);
  }
  return std::nullopt;
}

}  // namespace unietp
