#include "annotator/reading.h"

#include <algorithm>
#include <array>
#include <tuple>

#include "core/text.h"

namespace unietp {
namespace {

using P = Predicate;

constexpr std::array<std::string_view, 6> kBarePlaces{"on", "inside", "in", "next to", "beside", "on top of"};

}  // namespace

void PhraseReader::fail(const std::string& expected) {
  if (error_) return;
  std::string found = "the end of the text";
  if (!done()) found = std::string("'").append(tokens_[at_].text).append("'");
  error_ = Error{Error::Kind::Parse, "instruction", {1, column()}, expected + ", but " + found + " comes"};
}

const std::string& PhraseReader::peek(std::size_t ahead) const {
  static const std::string none;
  return at_ + ahead < tokens_.size() ? tokens_[at_ + ahead].text : none;
}

bool PhraseReader::comes(std::string_view words) const {
  for (std::size_t ahead = 0; !words.empty(); ++ahead) {
    const std::size_t end = std::min(words.find(' '), words.size());
    if (peek(ahead) != words.substr(0, end)) return false;
    words.remove_prefix(std::min(end + 1, words.size()));
  }
  return true;
}

bool PhraseReader::follows(std::string_view words) const {
  for (PhraseReader ahead = *this; !ahead.done() && ahead.peek() != "."; ++ahead.at_)
    if (ahead.comes(words)) return true;
  return false;
}

bool PhraseReader::accept(std::string_view words) {
  if (failed() || !comes(words)) return false;
  at_ += static_cast<std::size_t>(std::count(words.begin(), words.end(), ' ')) + 1;
  return true;
}

int PhraseReader::accept_one(std::initializer_list<std::string_view> choices) {
  int index = 0;
  for (const std::string_view choice : choices) {
    if (accept(choice)) return index;
    ++index;
  }
  return -1;
}

void PhraseReader::expect(std::string_view words) {
  if (!accept(words)) fail("expected '" + std::string(words) + "'");
}

NounPhrase PhraseReader::place() {
  const auto noun = comes("the") ? lexicon_.noun_at(tokens_, at_ + 1) : NounTable::Reading{};
  if (!noun.plural || noun.singular) return phrase();
  NounPhrase read;
  read.column = column();
  read.determiner = Determiner::Any;
  ++at_;
  return noun_after(read, true);
}

bool PhraseReader::slice_of_it(NounPhrase& read) {
  if (named_.empty() || accept_one({"one of the slices", "a slice of it"}) < 0) return false;
  NounPhrase whole;
  whole.determiner = Determiner::Known;
  whole.noun = named_.back();
  whole.column = read.column;
  read.noun = named_.back();
  for (Domain::Member& member : read.noun.members) member.slice = true;
  read.done.push_back({P::SliceOf, false, "", {std::move(whole)}});
  return true;
}

NounPhrase PhraseReader::bare_noun(bool plural) {
  NounPhrase read;
  read.column = column();
  return noun_after(read, plural);
}

NounPhrase PhraseReader::last_noun() {
  NounPhrase read;
  read.column = column();
  if (named_.empty()) fail("expected what is spoken of before this");
  if (!named_.empty()) read.noun = named_.back();
  return read;
}

bool PhraseReader::both_again(std::vector<NounPhrase>& phrases) {
  const std::size_t here = at_;
  if (named_.size() != 2 || !accept("both")) return false;
  if (peek() != "on" && peek() != "in" && peek() != "into" && peek() != "onto") {
    at_ = here;
    return false;
  }
  for (const Domain& noun : named_) {
    NounPhrase again;
    again.determiner = Determiner::Known;
    again.noun = noun;
    again.column = column();
    phrases.push_back(std::move(again));
  }
  return true;
}

void PhraseReader::set_put_last(const Clause& clause) {
  put_last_.reset();
  if (clause.complements.size() != 1 || clause.complements[0].object.size() != 1) return;
  put_last_ = clause.complements[0];
  NounPhrase place;
  place.determiner = Determiner::Known;
  place.noun = put_last_->object[0].noun;
  place.column = put_last_->object[0].column;
  put_last_->object[0] = std::move(place);
}

NounPhrase PhraseReader::last_moved() {
  NounPhrase read;
  read.column = column();
  if (!moved_) fail("expected what is put somewhere before this");
  read.noun = moved_.value_or(Domain());
  return read;
}

NounPhrase PhraseReader::noun_after(NounPhrase read, bool plural) {
  std::optional<Complement> front;
  auto noun = lexicon_.noun_at(tokens_, at_);
  while (noun.length == 0 && (result(read) || (front = adjective()))) {
    ++at_;
    if (front) read.modifiers.push_back(*front);
    front.reset();
    noun = lexicon_.noun_at(tokens_, at_);
  }
  if (!plural && room_before_noun(read)) noun = lexicon_.noun_at(tokens_, at_);
  const bool again = !plural && noun.length == 0 && one_again(read);
  if (noun.length == 0 && !again) {
    fail("expected the name of an object of this simulator");
    return read;
  }
  if (again) return described(std::move(read));
  if (plural ? !(noun.plural || noun.mass) : !(noun.singular || noun.mass))
    fail(plural ? "expected a plural" : "expected a singular");
  const std::size_t which = choices_.choose(noun.nouns.size());
  read.noun = noun.nouns[which];
  const auto is_cut = [](const Domain& one) { return !one.members.empty() && one.members[0].slice; };
  if (which > 0 && is_cut(read.noun) && !is_cut(noun.nouns[0])) read.absent.push_back(noun.nouns[0]);
  at_ += noun.length;
  while (comes("or")) {  // "one mug or cup"
    const auto next = lexicon_.noun_at(tokens_, at_ + 1);
    if (next.length == 0 || next.nouns.size() > 1 || read.noun.kind != Domain::Kind::Categories) break;
    at_ += 1 + next.length;
    for (const Domain::Member& member : next.nouns.front().members) read.noun.members.push_back(member);
  }
  std::sort(read.noun.members.begin(), read.noun.members.end(),
            [](const auto& a, const auto& b) { return std::tie(a.category, a.slice) < std::tie(b.category, b.slice); });
  if (depth_ == 0 && std::find(named_.begin(), named_.end(), read.noun) == named_.end()) named_.push_back(read.noun);
  read = described(std::move(read));
  if (read.determiner == Determiner::Every && read.modifiers.empty()) left_out(read);
  return read;
}

/// What follows a noun.
NounPhrase PhraseReader::described(NounPhrase read) {
  ++depth_;
  description(read);
  --depth_;
  contrast(read);
  return read;
}

/// "the red mug, not the blue one": there is another, which is not meant.
void PhraseReader::contrast(const NounPhrase& read) {
  if (read.determiner != Determiner::The || read.modifiers.empty() || !comes(", not the") || depth_ > 0) return;
  accept(", not");
  contrasts_.push_back(phrase());
  if (contrasts_.back().modifiers.empty()) fail("expected which one is not meant, such as 'the blue one', before this");
  accept(",");
}

void PhraseReader::description(NounPhrase& read) {
  direct_description(read);
  if (failed()) return;
  const bool negated = accept_one({"that isn't", "that aren't", "which isn't"}) >= 0;
  if (negated || accept_one({"that is", "that's", "that are", "which is", "which are"}) >= 0) {
    accept_one({"now", "currently"});
    do {
      read.modifiers.push_back(complement());
      if (failed()) return;
      if (negated) read.modifiers.back().negated = !read.modifiers.back().negated;
      const std::size_t here = at_;
      if (negated || !accept("and")) break;
      if (complement_comes()) continue;
      at_ = here;
      break;
    } while (true);
  }
}

/// "what I need for that", behind a sentence such as "I want to make a salad."
bool PhraseReader::needed_for_occasion(NounPhrase& read) {
  if (accept_one({"what i need for that", "what we need for that", "the right thing for that"}) < 0 &&
      (!occasion_ || !accept(need_)) && accept_one({"what i need", "what i'll need"}) < 0)
    return false;
  if (!occasion_) fail("what is needed is not clear without a sentence about an occasion, before this");
  read.noun = occasion_.value_or(Domain());
  read.by_function = true;
  return true;
}

/// "the kitchen cabinet": the cabinet in the kitchen, unless a category is called so.
bool PhraseReader::room_before_noun(NounPhrase& read) {
  const auto room = lexicon_.room_at(tokens_, at_);
  if (room.length == 0) return false;
  const auto whole = lexicon_.noun_at(tokens_, at_), rest = lexicon_.noun_at(tokens_, at_ + room.length);
  if (rest.length == 0 || rest.plural) return false;
  if (whole.length > room.length || (rest.length == 1 && peek(room.length) == "floor")) return false;
  NounPhrase place;
  place.determiner = Determiner::The;
  place.noun = room.nouns.front();
  place.column = column();
  at_ += room.length;
  read.modifiers.push_back({P::InRoom, false, "", {std::move(place)}});
  return true;
}

/// "one" in "the red one": one of what was named before.
bool PhraseReader::one_again(NounPhrase& read) {
  if (read.determiner != Determiner::The || named_.empty() || accept_one({"ones", "one"}) < 0) return false;
  read.noun = named_[named_.size() - 1 - choices_.choose(named_.size())];
  return true;
}

/// "… but the red one": all others are meant.
void PhraseReader::left_out(NounPhrase& read) {
  if (accept_one({"except for", "except", "but"}) < 0) return;
  NounPhrase other = phrase();
  if (failed()) return;
  if (other.determiner != Determiner::The || other.noun != read.noun || other.modifiers.empty() || other.except)
    return fail("expected which of them is left out, such as 'but the red one', before this");
  read.except = true;
  read.modifiers = std::move(other.modifiers);
}

void PhraseReader::exception(Clause& clause) {
  if (clause.subjects.size() != 1 || clause.subjects[0].determiner != Determiner::Every || clause.subjects[0].except ||
      !clause.subjects[0].modifiers.empty() || !comes("except"))
    return;
  left_out(clause.subjects[0]);
}

/// "A heated egg", of what is put somewhere: the egg is to be heated. "Cooked" may also say how it is now.
bool PhraseReader::result(NounPhrase& read) {
  if (!results_ || depth_ > 0 || read.determiner != Determiner::New) return false;
  for (const PredicatePhrase& made : result_phrases()) {
    if (peek() != made.words || (made.optional && choices_.choose(2) > 0)) continue;
    read.done.push_back({made.predicate, false, "", {}});
    return true;
  }
  return false;
}

/// "A box with a pen in it", of what is put somewhere: the pen is to be there, too.
void PhraseReader::with_something(NounPhrase& read) {
  if (!results_ || depth_ > 1 || !accept("with")) return;
  --depth_;  // what is named here can be spoken of
  Complement done{P::Inside, false, "", {phrase()}, true};
  ++depth_;
  const int where = accept_one({"in it", "inside it", "on it"});
  if (where < 0) fail("expected 'in it' or 'on it'");
  if (where == 2) done.predicate = P::On;
  read.done.push_back(std::move(done));
}

/// What follows a noun at once: "nearest to the sink", "where a plate is kept", "that you put a mug into", and, where
/// no place can be meant otherwise, "in the kitchen".
void PhraseReader::direct_description(NounPhrase& read) {
  if (comes("nearest to") || comes("closest to") || (bare_rooms_ && room_comes())) {
    read.modifiers.push_back(complement());
  } else if (lexicon_.where_at(tokens_, at_).length == 0 && !comes("where it is") && !comes("where they are") &&
             accept("where")) {
    read.modifiers.push_back({P::Inside, false, "", {phrase()}, true});
    if (accept_one({"is kept", "are kept", "is", "are"}) < 0) fail("expected 'is' or 'is kept'");
  } else if (accept("on which")) {
    read.modifiers.push_back({P::On, false, "", {phrase()}, true});
    if (accept_one({"stands", "stand"}) < 0) fail("expected 'stands' or 'stand'");
  } else if (bare_places_ &&
             std::any_of(kBarePlaces.begin(), kBarePlaces.end(), [&](auto words) { return comes(words); })) {
    bare_places_ = false;
    read.modifiers.push_back(complement());
    bare_places_ = true;
  }
  with_something(read);
  while (!failed() && accept("that you put")) {
    Complement done{P::Inside, false, "", {phrase()}, true};
    if (accept("on")) {
      done.predicate = P::On;
    } else {
      expect("into");
    }
    read.done.push_back(std::move(done));
  }
}

bool PhraseReader::room_comes() const { return comes("in the") && lexicon_.room_at(tokens_, at_ + 2).length > 0; }

std::vector<NounPhrase> PhraseReader::phrases(bool& any) {
  std::vector<NounPhrase> read{phrase()};
  any = false;
  while (!failed()) {
    const std::size_t here = at_;
    const bool comma = accept(",");
    const bool either = accept("or");
    if (!either && !accept("and") && !comma) break;
    if (!phrase_comes()) {
      at_ = here;
      break;
    }
    any |= either;
    read.push_back(phrase());
  }
  return read;
}

}  // namespace unietp
