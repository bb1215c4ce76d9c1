#include "annotator/realize.h"

#include <algorithm>
#include <initializer_list>
#include <string_view>

#include "annotator/clause_writing.h"
#include "annotator/frames.h"
#include "annotator/idiom_writing.h"
#include "annotator/if_or_else.h"
#include "annotator/naming.h"
#include "annotator/realize_proposition.h"
#include "core/text.h"

namespace unietp {
namespace {

using Text = std::optional<std::string>;
using Kind = Requirement::Kind;

class Realizer {
 public:
  Realizer(const Plan& plan, const NounTable& lexicon, const Wording& wording, Rng rng)
      : plan_(plan),
        rng_(rng),
        naming_(plan, lexicon, wording, rng_),
        clauses_(naming_, rng_),
        statement_share_(rng_.chance(0.3) ? 0.8 : 0.1),
        everyday_(wording.everyday) {}

  Text text() {
    std::vector<std::string> sentences;
    const Message& message = plan_.message;
    const std::size_t most = everyday_ ? 3 : message.size();  // commands in a sentence
    for (std::size_t i = 0; i < message.size();) {
      Text next;
      if (asks_plainly(message[i])) {
        std::size_t end = i + 1;
        while (end < message.size() && asks_plainly(message[end]) && end - i < most && (everyday_ || rng_.chance(0.75)))
          ++end;
        next = everyday_ ? everyday_sentence(i, end, sentences.empty()) : final_sentence(i, end, sentences.empty());
        i = end;
      } else {
        next = special_sentence(message[i]);
        ++i;
      }
      if (!next) return std::nullopt;
      sentences.push_back(*next);
      if (everyday_ && i == message.size() && leaves_open()) sentences.emplace_back("Leave it open.");
    }
    return join(sentences, " ");
  }

 private:
  /// Whether it is one of the commands that "and" can join: not "if a fridge is open, …".
  bool asks_plainly(const Requirement& said) const {
    return said.kind == Kind::Final && said.clauses.size() == 1 && said.clauses[0].given.empty() &&
           !(everyday_ && says_if_or_else(said.clauses[0]));
  }

  /// Whether the last command puts something into what was opened for that, and that is to stay open.
  bool leaves_open() const {
    const auto says = [](const Requirement& said, Predicate predicate) {
      return said.kind == Kind::Final && said.clauses.size() == 1 && said.clauses[0].kind == Clause::Kind::Simple &&
             said.clauses[0].given.empty() && said.clauses[0].complements.size() == 1 &&
             said.clauses[0].complements[0].predicate == predicate && !said.clauses[0].complements[0].negated;
    };
    const Message& message = plan_.message;
    if (message.size() < 2 || !says(message.back(), Predicate::Inside)) return false;
    const std::string& opened = message.back().clauses[0].complements[0].object[0].variable;
    return !opened.empty() && std::any_of(message.begin(), message.end(), [&](const Requirement& said) {
      return says(said, Predicate::Open) && said.clauses[0].subjects.size() == 1 &&
             said.clauses[0].subjects[0].variable == opened;
    });
  }

  std::string pick(std::initializer_list<const char*> choices) {
    return *(choices.begin() + rng_.below(choices.size()));
  }

  /// "Wash a pan and put it in the sink."
  Text everyday_sentence(std::size_t from, std::size_t to, bool is_first) {
    std::vector<std::string> parts;
    for (std::size_t i = from; i < to; ++i) {
      const Clause& clause = plan_.message[i].clauses[0];
      if (i > from && one_for_each(plan_.message[i - 1].clauses[0], clause)) {
        const Text each = naming_.singular(clause.subjects[1].noun);
        if (!each) return std::nullopt;
        parts.back() = with_enough(parts.back()) + ", one for each " + *each + " there";
        continue;
      }
      const Text part = clauses_.command(clause);
      if (!part) return std::nullopt;
      parts.push_back(*part);
    }
    // "Take the vase off the shelf and put it on the desk. Close the fridge."
    // "Put two books on the desk. Only one can stay on the bench."
    const auto is_long = [](const std::string& part) {
      return part.find(" and put ") != part.npos || part.starts_with("only ");
    };
    if (parts.size() < 2 || std::none_of(parts.begin(), parts.end(), is_long))
      return asked(listed(parts, "and"), is_first);
    std::vector<std::string> sentences;
    for (const std::string& part : parts)  // of two places
      if (&part != &parts[0] && (part.ends_with(" on it") || part.ends_with(" in it"))) return std::nullopt;
    for (const std::string& part : parts) sentences.push_back(*asked(part, is_first && sentences.empty()));
    return join(sentences, " ");
  }

  /// Three plates want three forks, which are not "a couple".
  static std::string with_enough(std::string part) {
    constexpr std::string_view kVague = " a couple of ";
    if (const auto at = part.find(kVague); at != std::string::npos) part.replace(at, kVague.size(), " enough ");
    return part;
  }

  /// "Put enough forks on the table, one for each plate there.": as many there as plates.
  static bool one_for_each(const Clause& put, const Clause& counted) {
    if (put.kind != Clause::Kind::Simple || counted.kind != Clause::Kind::Compare || !same_place(counted) ||
        counted.comparison != Comparison::Equal || put.subjects.size() != 1 || put.complements.size() != 1)
      return false;
    const Complement &place = put.complements[0], &there = counted.complements[0];
    return put.subjects[0].noun == counted.subjects[0].noun && place.predicate == there.predicate &&
           !place.object.empty() && place.object[0].variable == there.object[0].variable;
  }

  Text final_sentence(std::size_t from, std::size_t to, bool is_first) {
    std::vector<std::string> parts;
    const bool stated = rng_.chance(statement_share_);
    const std::string be = pick({"should be", "must be", "has to be"});
    const bool closing = rng_.chance(0.5);
    for (std::size_t i = from; i < to; ++i) {
      const Clause& clause = plan_.message[i].clauses[0];
      Text part;
      if (!stated) {
        part = clauses_.command(clause);
      } else {
        part = clauses_.statement(clause, closing ? be : "is");
      }
      if (!part) return std::nullopt;
      parts.push_back(*part);
    }
    const std::string body = listed(parts, "and");
    if (!stated) return asked(body, is_first);
    if (closing)
      return sentence(pick({"in the end, ", "when you are done, ", "at the end, ", "by the end, "}) + body, '.');
    return asked(pick({"make sure that ", "see to it that ", "ensure that "}) + body, is_first);
  }

  Text asked(const std::string& command, bool is_first) {
    return everyday_ ? everyday_request(command, is_first, rng_) : framed_request(command, is_first, rng_);
  }

  Text special_sentence(const Requirement& said) {
    const auto& clauses = said.clauses;
    switch (said.kind) {
      case Kind::Fact:
        return fact_sentence(clauses[0].subjects[0], naming_, rng_);
      case Kind::Final:
        return conditional(clauses[0]);
      case Kind::Once:
        return once_done(clauses[0], clauses[1]);
      case Kind::Choose: {
        if (naming_.was_named(clauses[0].subjects[0].variable)) return std::nullopt;  // "Choose it."
        const auto named = naming_.phrase(clauses[0].subjects[0], {.chosen = true});
        if (!named) return std::nullopt;
        return sentence("choose " + named->text, '.');
      }
      case Kind::Sometime: {
        if (everyday_ || rng_.chance(0.5)) return framed("at some point, ", clauses_.command(clauses[0]), "");
        return framed("make sure that at some point ", clauses_.statement(clauses[0], "is"), "");
      }
      case Kind::Always: {
        if (everyday_ && stays_where_it_is_told(clauses[0], naming_)) return std::nullopt;
        if (everyday_)
          if (const Text left = left_alone(clauses[0], naming_)) return sentence(*left, '.');
        if (everyday_ || rng_.chance(0.6))
          if (const Text kept = clauses_.keeping(clauses[0]))
            return framed("", kept, pick({" the whole time", " at all times"}));
        return framed(pick({"make sure that ", "please make sure that "}), clauses_.statement(clauses[0], "is"),
                      pick({" the whole time", " at all times"}));
      }
      case Kind::Until: {
        Text kept = everyday_ || rng_.chance(0.6) ? clauses_.keeping(clauses[0]) : std::nullopt;
        if (kept) {
          const Text until = clauses_.statement(clauses[1], "is");
          return until ? framed("", Text(*kept + " until " + *until), "") : std::nullopt;
        }
        return linked("make sure that ", clauses, " until ");
      }
      case Kind::Before:
        return linked("make sure that ", clauses, " before ");
      case Kind::Need: {
        const Text wanted = needed(clauses[0]);
        return framed(pick({"I'd like ", "I'd like ", "I could use ", "I want "}), wanted, "");
      }
      case Kind::Then:
      case Kind::ThenKept:
        return one_after_another(said);
      case Kind::UntilThen: {
        const Text kept = clauses_.keeping(clauses[0]);
        const Text until = kept ? clauses_.statement(clauses[1], "is") : std::nullopt;
        const Text then = until ? clauses_.command(clauses[2]) : std::nullopt;
        return then ? framed("", Text(*kept + " until " + *until + ", then " + *then), "") : std::nullopt;
      }
      case Kind::OnlyThen: {
        const Text first = clauses_.command(clauses[0]);
        if (everyday_ && first && first->find(" the same ") != first->npos) return std::nullopt;
        const auto late = first ? naming_.phrase(clauses[1].subjects[0], {}) : std::nullopt;
        return late ? framed("", Text(*first + (everyday_ ? " first, and then " : ", and only then ") + late->text), "")
                    : std::nullopt;
      }
      case Kind::Again: {
        if (clauses.size() > 2) return reopened(clauses);
        const Text first = clauses_.command(clauses[0]);
        const Text second = first ? clauses_.command(clauses[1]) : std::nullopt;
        if (!second) return std::nullopt;
        return framed(everyday_ ? "" : pick({"", "please "}), Text(*first + pick({", then ", " and then "}) + *second),
                      " again");
      }
      case Kind::Stated:
        return stated(said);
      case Kind::Contrast:  // contrast.h
        return std::nullopt;
    }
    return std::nullopt;
  }

  /// "First put the egg in the fridge, then the potato."
  Text one_after_another(const Requirement& said) {
    const auto& clauses = said.clauses;
    const Text first = clauses_.command(clauses[0]);
    const bool another_place = everyday_ && !said.inverted && first && goes_on_to_another_place(*first, clauses);
    const bool same_place = everyday_ && !said.inverted && first && goes_to_the_same_place(*first, clauses);
    if (same_place) {
      const auto thing = naming_.phrase(clauses[1].subjects[0], {});
      return thing && thing->text != "it" ? framed("", Text(*first + ", then " + thing->text), "") : std::nullopt;
    }
    const Text second = another_place ? naming_.complement(clauses[1].complements[0], {})
                        : first       ? clauses_.command(clauses[1])
                                      : std::nullopt;
    if (!second) return std::nullopt;
    if (everyday_) return in_order(*first, *second, said.inverted);
    const std::string kept =
        said.kind == Kind::Then
            ? ""
            : pick({", and leave both that way", ", with both still so at the end", ", and keep both that way"});
    if (said.inverted) return framed("before you ", Text(*first + ", please " + *second), kept);
    return framed(pick({"first ", "first, ", "please first "}),
                  Text(*first + pick({", then ", " and then ", ", and after that "}) + *second), kept);
  }

  /// "Open the fridge, take all the eggs out of it and close it again."
  Text reopened(const std::vector<Clause>& clauses) {
    std::vector<std::string> parts;
    const bool takes_out = clauses.size() == 3 && clauses[1].put_down && !clauses[0].subjects.empty() &&
                           naming_.is_alone(clauses[0].subjects[0].noun) &&
                           clauses[1].complements[0].predicate == Predicate::Inside;
    for (const Clause& clause : clauses) {
      if (takes_out && &clause == &clauses.front()) continue;  // who closes it again has opened it
      const Text part = clauses_.command(clause);
      if (!part) return std::nullopt;
      parts.push_back(takes_out ? replace_all(*part, " and put ", ", put ") : *part);
    }
    const std::string last = parts.back();
    parts.pop_back();
    return sentence(join(parts, ", ") + ", and " + last + " again", '.');
  }

  /// "Put the egg on the table and then in the sink."
  static bool goes_on_to_another_place(const std::string& first, const std::vector<Clause>& clauses) {
    const auto puts = [](const Clause& clause) {
      return clause.kind == Clause::Kind::Simple && clause.subjects.size() == 1 && clause.complements.size() == 1 &&
             clause.complements[0].object.size() == 1 && !clause.complements[0].negated;
    };
    if (!puts(clauses[0]) || !puts(clauses[1]) || clauses[0].subjects[0].variable.empty()) return false;
    return clauses[0].subjects[0].variable == clauses[1].subjects[0].variable &&
           (first.starts_with("put ") || first.starts_with("place ")) && first.find(" it ") == first.npos;
  }

  /// "Put the egg in the fridge, then the potato."
  bool goes_to_the_same_place(const std::string& first, const std::vector<Clause>& clauses) const {
    const auto puts = [](const Clause& clause) {
      return clause.kind == Clause::Kind::Simple && clause.subjects.size() == 1 && clause.complements.size() == 1 &&
             clause.complements[0].object.size() == 1 && !clause.complements[0].negated &&
             clause.subjects[0].determiner == Determiner::New;
    };
    const NounPhrase& next = clauses[1].subjects[0];
    if (!next.modifiers.empty() && !naming_.was_named(next.variable)) return false;
    const Complement &place = clauses[0].complements[0], &again = clauses[1].complements[0];
    return puts(clauses[0]) && puts(clauses[1]) && place.predicate == again.predicate &&
           !place.object[0].variable.empty() && place.object[0].variable == again.object[0].variable &&
           clauses[0].subjects[0].variable != clauses[1].subjects[0].variable &&
           (first.starts_with("put ") || first.starts_with("place ") || first.starts_with("move ") ||
            first.find(" and put it in ") != first.npos);
  }

  /// "First wash a pan, then heat it."; inverted, "Open the oven, but close the dishwasher first."
  Text in_order(const std::string& first, const std::string& second, bool inverted) {
    if (inverted) {  // "before you open it, …" does not ask to open it
      const bool long_one = second.find(" and ") != second.npos || second.find(", ") != second.npos;
      if (long_one || rng_.chance(0.4)) return framed("", Text(first + ", but first " + second), "");
      return framed("", Text(first + ", but " + second + " first"), "");
    }
    if (first.find(" and put ") != first.npos) return sentence(first, '.') + " " + sentence("then " + second, '.');
    if (rng_.chance(0.2)) return framed("first ", Text(first + ", then " + second), "");
    return framed("", Text(first + (rng_.chance(0.6) ? ", then " : " and then ") + second), "");
  }

  /// "Choose a mug. Make sure of this: at all times, if the mug is hot, then …"
  Text stated(const Requirement& said) {
    std::string text;
    for (const NounPhrase& about : said.clauses[0].subjects) {
      if (naming_.was_named(about.variable)) continue;
      const auto named = naming_.phrase(about, {.chosen = true});
      if (!named) return std::nullopt;
      text += sentence("choose " + named->text, '.') + " ";
    }
    const Text body = proposition_words(said.stated[0], naming_, rng_);
    if (!body) return std::nullopt;
    const std::string opening =
        pick({"make sure of this: ", "please make sure of this: ", "see to the following: ", "what counts is this: ",
              "the goal is this: ", "what is wanted is this: ", "please take care of this: "});
    return text + sentence(opening + *body, '.');
  }

  /// "if a fridge is open, close a cabinet"
  Text conditional(const Clause& clause) {
    const std::size_t before = naming_.named_count();
    if (everyday_)
      if (Text either = if_or_else(clause, naming_, clauses_)) return either;
    naming_.forget_after(before);
    if (clause.given.empty()) return framed("", clauses_.command(clause), "");
    const Text condition = clauses_.given(clause);
    const Text then = condition ? clauses_.command(clause) : std::nullopt;
    if (!then) return std::nullopt;
    return framed(condition->substr(1) + (everyday_ ? ", " : pick({", please ", ", then "})), then, "");
  }

  /// "once you've put the towel in the washer, turn it on"
  Text once_done(const Clause& sooner, const Clause& later) {
    const Text put = clauses_.command(sooner);
    // Of the verbs that move things, these are their own participles.
    if (!put || !(put->starts_with("put ") || put->starts_with("set "))) return std::nullopt;
    if (everyday_) naming_.set_topic(""), naming_.mention_again("");  // "turn it on" could be either
    const Text then = clauses_.command(later);
    if (!then) return std::nullopt;
    if (everyday_) {
      const bool inside = sooner.complements[0].predicate == Predicate::Inside;
      return sentence(*put, '.') + " " + sentence((inside ? "once it's in, " : "once it's there, ") + *then, '.');
    }
    return framed(pick({"once you've ", "once you've ", "as soon as you've "}), Text(*put + ", " + *then), "");
  }

  /// "a hot potato"
  Text needed(const Clause& clause) {
    NounPhrase wanted = clause.subjects[0];
    if (!wanted.modifiers.empty() || naming_.was_named(wanted.variable)) return std::nullopt;
    wanted.modifiers = {clause.complements[0]};
    const auto thing = naming_.phrase(wanted, {.wanted = true});
    naming_.set_topic(wanted.variable);
    if (!thing) return std::nullopt;
    return everyday_ ? replace_all(thing->text, " hot ", " warm ") : thing->text;
  }

  static Text framed(const std::string& before, const Text& body, const std::string& after) {
    return body ? Text(sentence(before + *body + after, '.')) : std::nullopt;
  }

  Text linked(const std::string& before, const std::vector<Clause>& clauses, const std::string& link) {
    const Text first = clauses_.statement(clauses[0], "is");
    const Text second = first ? clauses_.statement(clauses[1], "is") : std::nullopt;
    return second ? framed(before, Text(*first + link + *second), "") : std::nullopt;
  }

  const Plan& plan_;
  Rng rng_;
  Naming naming_;
  ClauseWriter clauses_;
  double statement_share_;
  bool everyday_;
};

}  // namespace

std::optional<std::string> fact_sentence(const NounPhrase& thing, Naming& naming, Rng& rng) {
  NounPhrase body = thing;
  std::vector<Complement> places;
  for (const Complement& modifier : thing.modifiers)
    if (!modifier.object.empty()) places.push_back(modifier);
  std::erase_if(body.modifiers, [](const Complement& modifier) { return !modifier.object.empty(); });
  // Of furniture that stands somewhere nobody is told that it is there.
  if (places.size() != 1 || !naming.is_carried(thing.noun)) return std::nullopt;
  const auto named = naming.phrase(body, {.wanted = true});
  if (!named || named->plural) return std::nullopt;
  const bool unique = places[0].object[0].there < 2;
  const Text where = naming.complement(places[0], {.inside_description = true, .unique = unique});
  naming.mention_again(places[0].predicate == Predicate::NextTo ? "" : thing.variable);
  naming.set_topic(thing.variable);
  const std::string there = rng.chance(0.5) ? "there is " : "there's ";
  return where ? Text(sentence(there + named->text + " " + *where, '.')) : std::nullopt;
}

std::optional<std::string> realize(const Plan& plan, const NounTable& lexicon, const Wording& wording, Rng rng) {
  auto text = Realizer(plan, lexicon, wording, rng).text();
  for (const char* twice : {" that that ", " it in it", " it on it", " on it on "})  // right, and hard to read
    if (text && text->find(twice) != std::string::npos) return std::nullopt;
  return text;
}

}  // namespace unietp
