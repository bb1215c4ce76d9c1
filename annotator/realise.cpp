#include "annotator/realise.h"

#include <algorithm>
#include <cctype>
#include <initializer_list>

#include "annotator/asides.h"
#include "annotator/naming.h"
#include "annotator/realise_proposition.h"
#include "annotator/verbs.h"
#include "core/text.h"

namespace unietp {
namespace {

using Text = std::optional<std::string>;
using Kind = Requirement::Kind;

/// "a, b and c"
std::string listed(const std::vector<std::string>& parts, const char* word) {
  std::string text;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i > 0) text += i + 1 < parts.size() ? ", " : std::string(" ") + word + " ";
    text += parts[i];
  }
  return text;
}

std::string sentence(std::string text, char end) {
  if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text + end;
}

class Realiser {
 public:
  Realiser(const Plan& plan, const NounTable& lexicon, const std::string& style, Rng rng)
      : plan_(plan),
        rng_(rng),
        naming_(plan, lexicon, style, rng_),
        statement_share_(rng_.chance(0.3) ? 0.8 : 0.1),
        nested_(style == "nested-syntax") {}

  Text text() {
    std::vector<std::string> sentences;
    const Message& message = plan_.message;
    for (std::size_t i = 0; i < message.size();) {
      Text next;
      if (message[i].kind == Kind::Final && message[i].clauses[0].given.empty()) {
        std::size_t end = i + 1;
        while (end < message.size() && message[end].kind == Kind::Final && message[end].clauses[0].given.empty() &&
               (nested_ || rng_.chance(0.75)))
          ++end;
        next = final_sentence(i, end, sentences.empty());
        i = end;
      } else {
        next = special_sentence(message[i]);
        ++i;
      }
      if (!next) return std::nullopt;
      sentences.push_back(*next);
    }
    return join(sentences, " ");
  }

 private:
  std::string pick(std::initializer_list<const char*> choices) {
    return *(choices.begin() + rng_.below(choices.size()));
  }

  Text final_sentence(std::size_t from, std::size_t to, bool is_first) {
    std::vector<std::string> parts;
    const bool stated = !nested_ && rng_.chance(statement_share_);
    const std::string be = pick({"should be", "must be", "has to be"});
    const std::size_t frame = rng_.below(6);
    for (std::size_t i = from; i < to; ++i) {
      const Clause& clause = plan_.message[i].clauses[0];
      Text part;
      if (!stated) {
        part = command(clause);
      } else {
        part = statement(clause, frame < 3 ? "is" : be);
      }
      if (!part) return std::nullopt;
      parts.push_back(*part);
    }
    const std::string body = listed(parts, "and");
    if (!stated) return asked(body, is_first);
    switch (frame) {
      case 0:
        return sentence("make sure that " + body, '.');
      case 1:
        return sentence("please see to it that " + body, '.');
      case 2:
        return sentence("please ensure that " + body, '.');
      case 3:
        return sentence("in the end, " + body, '.');
      case 4:
        return sentence("when you are done, " + body, '.');
      default:
        return sentence("at the end, " + body, '.');
    }
  }

  std::string asked(const std::string& command, bool is_first) {
    if (nested_) return nested(command);
    const bool forbids = command.starts_with("do not ") || command.find(" do not ") != std::string::npos;
    if (forbids) return sentence((rng_.chance(0.3) ? "please " : "") + command, '.');  // "could you do not" is wrong
    switch (rng_.below(12)) {
      case 0:
        return sentence("please " + command, '.');
      case 1:
        return sentence("could you " + command, '?');
      case 2:
        return sentence("could you please " + command, '?');
      case 3:
        return sentence("can you " + command, '?');
      case 4:
        return sentence("i need you to " + command, '.');
      case 5:
        return sentence("I'd like you to " + command, '.');
      case 6:
        return sentence("would you " + command + ", please", '?');
      case 7:
        return is_first ? sentence("your task is to " + command, '.') : sentence("also, " + command, '.');
      case 8:
        return is_first ? sentence("I want you to " + command, '.') : sentence("also, please " + command, '.');
      default:
        return sentence(command, '.');
    }
  }

  /// One long sentence: "I was wondering whether you, who …, could put …".
  std::string nested(const std::string& command) {
    const auto openings = nested_openings();
    std::string text(openings[rng_.below(openings.size())]);
    text = replace_all(replace_all(text, " ,", ","), " i ", " I ");
    if (text.starts_with("i ")) text[0] = 'I';
    return sentence(text + " " + command, '.');
  }

  Text special_sentence(const Requirement& said) {
    const auto& clauses = said.clauses;
    switch (said.kind) {
      case Kind::Final:
        return conditional(clauses[0]);
      case Kind::Choose: {
        const auto named = naming_.phrase(clauses[0].subjects[0], {});
        if (!named) return std::nullopt;
        return sentence("choose " + named->text, '.');
      }
      case Kind::Sometime: {
        if (rng_.chance(0.5)) return framed("at some point, ", command(clauses[0]), "");
        return framed("make sure that at some point ", statement(clauses[0], "is"), "");
      }
      case Kind::Always: {
        if (rng_.chance(0.6))
          if (const Text kept = keeping(clauses[0]))
            return framed("", kept, pick({" the whole time", " at all times"}));
        return framed(pick({"make sure that ", "please make sure that "}), statement(clauses[0], "is"),
                      pick({" the whole time", " at all times"}));
      }
      case Kind::Until: {
        Text kept = rng_.chance(0.6) ? keeping(clauses[0]) : std::nullopt;
        if (kept) {
          const Text until = statement(clauses[1], "is");
          return until ? framed("", Text(*kept + " until " + *until), "") : std::nullopt;
        }
        return linked("make sure that ", clauses, " until ");
      }
      case Kind::Before:
        return linked("make sure that ", clauses, " before ");
      case Kind::Need: {
        const Text wanted = needed(clauses[0]);
        return framed(pick({"someone wants ", "someone would like ", "somebody needs "}), wanted, "");
      }
      case Kind::Then:
      case Kind::ThenKept: {
        const Text first = command(clauses[0]);
        const Text second = first ? command(clauses[1]) : std::nullopt;
        if (!second) return std::nullopt;
        const std::string kept =
            said.kind == Kind::Then
                ? ""
                : pick({", and leave both that way", ", with both still so at the end", ", and keep both that way"});
        if (said.inverted) return framed("before you ", Text(*first + ", please " + *second), kept);
        return framed(pick({"first ", "first, ", "please first "}),
                      Text(*first + pick({", then ", " and then ", ", and after that "}) + *second), kept);
      }
      case Kind::Again: {
        const Text first = command(clauses[0]);
        const Text second = first ? command(clauses[1]) : std::nullopt;
        if (!second) return std::nullopt;
        return framed(pick({"", "please "}), Text(*first + pick({", then ", " and then "}) + *second), " again");
      }
      case Kind::Stated:
        return stated(said);
    }
    return std::nullopt;
  }

  /// "Choose a mug. Make sure of this: at all times, if the mug is hot, then …"
  Text stated(const Requirement& said) {
    std::string text;
    for (const NounPhrase& about : said.clauses[0].subjects) {
      if (naming_.was_named(about.variable)) continue;
      const auto named = naming_.phrase(about, {});
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
    const Text condition = given(clause);
    const Text then = condition ? command(clause) : std::nullopt;
    if (!then) return std::nullopt;
    return framed(condition->substr(1) + pick({", please ", ", then "}), then, "");
  }

  /// "a hot potato on a table"
  Text needed(const Clause& clause) {
    NounPhrase wanted = clause.subjects[0];
    if (!wanted.modifiers.empty() || naming_.was_named(wanted.variable)) return std::nullopt;
    wanted.modifiers = {clause.complements[0]};
    const auto thing = naming_.phrase(wanted, {.wanted = true});
    const Text where = naming_.complement(clause.complements[1], {});
    return thing && where ? Text(thing->text + " " + *where) : std::nullopt;
  }

  static Text framed(const std::string& before, const Text& body, const std::string& after) {
    return body ? Text(sentence(before + *body + after, '.')) : std::nullopt;
  }

  Text linked(const std::string& before, const std::vector<Clause>& clauses, const std::string& link) {
    const Text first = statement(clauses[0], "is");
    const Text second = first ? statement(clauses[1], "is") : std::nullopt;
    return second ? framed(before, Text(*first + link + *second), "") : std::nullopt;
  }

  /// "keep every fridge closed"
  Text keeping(const Clause& clause) {
    if (clause.kind != Clause::Kind::Simple || clause.complements.size() != 1 || clause.any_subject)
      return std::nullopt;
    if (clause.subjects[0].determiner == Determiner::No || clause.subjects[0].determiner == Determiner::Agent)
      return std::nullopt;
    if (clause.subjects[0].determiner == Determiner::Any) return std::nullopt;
    const auto subjects = subjects_of(clause);
    if (!subjects) return std::nullopt;
    const Text said = naming_.complement(clause.complements[0], place_of(clause));
    return said ? Text("keep " + subjects->text + " " + *said) : std::nullopt;
  }

  static Place place_of(const Clause& clause) {
    Place place;
    for (const NounPhrase& subject : clause.subjects) {
      place.beside_every |= subject.determiner == Determiner::Every;
      place.beside_none |= subject.determiner == Determiner::No;
    }
    for (const Complement& complement : clause.complements) place.beside_none |= complement.negated;
    return place;
  }

  std::optional<Words> subjects_of(const Clause& clause, Place place = {}) {
    std::vector<std::string> texts;
    bool plural = clause.subjects.size() > 1 && !clause.any_subject;
    for (const NounPhrase& subject : clause.subjects) {
      const std::size_t before = naming_.named_count();
      const auto words = naming_.phrase(subject, place);
      if (!words) return std::nullopt;
      if (clause.any_subject && naming_.named_count() > before) naming_.forget_after(before);
      texts.push_back(words->text);
      plural |= words->plural;
    }
    return Words{listed(texts, clause.any_subject ? "or" : "and"), plural};
  }

  static std::string agreed(const std::string& be, bool plural) {
    if (!plural) return be;
    if (be == "is") return "are";
    return be == "has to be" ? "have to be" : be;
  }

  Text statement(const Clause& clause, const std::string& be) {
    if (clause.kind == Clause::Kind::And || clause.kind == Clause::Kind::Or) {
      return joined_parts(clause, [&](const Clause& part) { return statement(part, be); });
    }
    if (clause.kind == Clause::Kind::Compare) return comparison(clause, be);
    const auto subjects = subjects_of(clause);
    if (!subjects) return std::nullopt;
    std::vector<std::string> parts;
    for (const Complement& complement : clause.complements) {
      const Text said = naming_.complement(complement, place_of(clause));
      if (!said) return std::nullopt;
      parts.push_back(*said);
    }
    const std::string either = clause.any_complement && rng_.chance(0.6) ? "either " : "";
    return subjects->text + " " + agreed(be, subjects->plural) + " " + either +
           listed(parts, clause.any_complement ? "or" : "and");
  }

  template <class Say>
  Text joined_parts(const Clause& clause, Say say) {
    const bool either = clause.kind == Clause::Kind::Or;
    std::vector<std::string> parts;
    for (const Clause& part : clause.parts) {
      if (part.kind == Clause::Kind::Or || (!either && part.kind != Clause::Kind::Simple)) return std::nullopt;
      const std::size_t before = naming_.named_count();
      const Text said = say(part);
      const Text condition = said ? given(part) : std::nullopt;
      if (!condition) return std::nullopt;
      if (either) naming_.forget_after(before);
      parts.push_back(*said + *condition);
    }
    return (either ? "either " : "") + listed(parts, either ? "or" : "and");
  }

  /// " if a fridge is open", or nothing.
  Text given(const Clause& part) {
    std::string text;
    for (const NounPhrase& there : part.given) {
      NounPhrase bare = there;
      bare.modifiers.clear();
      const auto subject = naming_.phrase(bare, {});
      if (!subject) return std::nullopt;
      std::vector<std::string> states;
      for (const Complement& modifier : there.modifiers) {
        const Text said = naming_.complement(modifier, {});
        if (!said) return std::nullopt;
        states.push_back(*said);
      }
      text += (text.empty() ? " if " : " and ") + subject->text + " is " + listed(states, "and");
    }
    return text;
  }

  Text comparison(const Clause& clause, const std::string& be) {
    const auto more = naming_.plural(clause.subjects[0]);
    const Text here = naming_.complement(clause.complements[0], place_of(clause));
    const auto fewer = naming_.plural(clause.subjects[1]);
    const Text there = naming_.complement(clause.complements[1], place_of(clause));
    if (!more || !here || !fewer || !there) return std::nullopt;
    const bool greater = clause.comparison == Comparison::Greater;
    const std::string quantity = greater                                  ? "more "
                                 : clause.comparison == Comparison::Equal ? "as many "
                                                                          : "at least as many ";
    const std::string link = greater ? " than " : " as ";
    const std::string& second = *more == *fewer && rng_.chance(0.5) ? std::string() : *fewer + " ";
    return "there " + agreed(be, true) + " " + quantity + *more + " " + *here + link + second + *there;
  }

  /// An imperative, without frame.
  Text command(const Clause& clause) {
    if (clause.kind == Clause::Kind::And || clause.kind == Clause::Kind::Or)
      return joined_parts(clause, [&](const Clause& part) { return command(part); });
    if (clause.kind == Clause::Kind::Simple) {
      bool special = false;
      const Text text = special_command(clause, special);
      if (special) return text;
      if (clause.complements.size() == 1) {
        const auto patterns = verbs(clause.complements[0]);
        const bool clean_subject = clause.subjects[0].determiner != Determiner::No &&
                                   clause.subjects[0].determiner != Determiner::AtMost &&
                                   clause.subjects[0].determiner != Determiner::Agent;
        if (!patterns.empty() && clean_subject) return filled(patterns[rng_.below(patterns.size())], clause);
      }
    }
    const Text stated = statement(clause, "is");
    return stated ? Text("make sure that " + *stated) : std::nullopt;
  }

  /// "go to the kitchen", "remove every mug from the table", "put every mug either in a box or on a table".
  Text special_command(const Clause& clause, bool& special) {
    const Complement& said = clause.complements[0];
    const NounPhrase& subject = clause.subjects[0];
    if (subject.determiner == Determiner::Agent && said.predicate == Predicate::InRoom && !said.negated) {
      special = true;
      const auto room = naming_.phrase(said.object[0], {});
      return room ? Text("go to " + room->text) : std::nullopt;
    }
    const bool single = clause.complements.size() == 1 && clause.subjects.size() == 1 && !said.negated;
    if (single && subject.determiner == Determiner::No && said.predicate == Predicate::Held && rng_.chance(0.7)) {
      special = true;
      NounPhrase any = subject;
      any.determiner = Determiner::Any;
      const auto held = naming_.phrase(any, {});
      return held ? Text("do not hold " + held->text) : std::nullopt;
    }
    const bool place = said.predicate == Predicate::On || said.predicate == Predicate::Inside;
    if (single && subject.determiner == Determiner::No && place && rng_.chance(0.8)) {
      special = true;
      NounPhrase every = subject;
      every.determiner = Determiner::Every;
      const auto taken = naming_.phrase(every, {});
      const auto from = naming_.phrase(said.object[0], {.beside_every = true});
      if (!taken || !from) return std::nullopt;
      if (said.predicate == Predicate::Inside) return "take " + taken->text + " out of " + from->text;
      const bool remove = rng_.chance(0.6);
      return (remove ? "remove " : "take ") + taken->text + (remove ? " from " : " off ") + from->text;
    }
    if (!clause.any_complement || clause.subjects.size() != 1 || subject.determiner == Determiner::No)
      return std::nullopt;
    for (const Complement& part : clause.complements)
      if (part.negated || (part.predicate != Predicate::On && part.predicate != Predicate::Inside)) return std::nullopt;
    special = true;
    const auto moved = naming_.phrase(subject, {});
    if (!moved) return std::nullopt;
    std::vector<std::string> places;
    for (const Complement& part : clause.complements) {
      const Text where = naming_.complement(part, place_of(clause));
      if (!where) return std::nullopt;
      places.push_back(*where);
    }
    return pick({"put ", "place "}) + moved->text + " either " + listed(places, "or");
  }

  /// "put the mug that is on a desk in a box" could be read as a desk in a box: "take … and put it in a box" cannot.
  Text taken_first(const Clause& clause) {
    const auto subject = naming_.phrase(clause.subjects[0], {});
    if (!subject || subject->plural) return std::nullopt;
    const Text where = naming_.complement(clause.complements[0], place_of(clause));
    return where ? Text("take " + subject->text + pick({" and put it ", " and place it "}) + *where) : std::nullopt;
  }

  bool described_by_place(const Clause& clause) const {
    const NounPhrase& subject = clause.subjects[0];
    if (clause.subjects.size() != 1 || subject.modifiers.empty() || naming_.was_named(subject.variable)) return false;
    if (subject.determiner != Determiner::New) return false;
    return !subject.modifiers.back().object.empty() && !clause.complements[0].object.empty();
  }

  /// "turn it off" rather than "turn off it"; no long object before "up".
  static std::string smooth(const std::string& pattern, const std::string& subject, const Complement& said) {
    const auto parted = [](const std::string& words) {
      return words.find(' ') + 1 == words.find("{s}") && !words.ends_with("{s}") && words.find("{o}") == words.npos;
    };
    const bool is_long = std::count(subject.begin(), subject.end(), ' ') > 2;
    for (const std::string words : verbs(said)) {
      const bool direct = words.find(' ') + 1 == words.find("{s}");
      if (subject == "it" && direct && pattern.find(' ') + 1 != pattern.find("{s}")) return words;
      if (is_long && parted(pattern) && !parted(words)) return words;
    }
    return pattern;
  }

  Text filled(const std::string& pattern, const Clause& clause) {
    if (described_by_place(clause) && !pattern.starts_with("attach")) return taken_first(clause);
    // Only where the reader expects no place: verbs that end with what they are done to.
    const bool bare = clause.complements[0].object.empty() && pattern.ends_with(" {s}");
    const auto subjects = subjects_of(clause, {.bare = bare});
    if (!subjects) return std::nullopt;
    std::string text = smooth(pattern, subjects->text, clause.complements[0]);
    text = replace_all(text, "{m}", replace_all(clause.complements[0].symbol, "_", " "));
    if (!clause.complements[0].object.empty()) {
      const auto object = naming_.phrase(clause.complements[0].object[0], place_of(clause));
      if (!object) return std::nullopt;
      text = replace_all(text, "{o}", object->text);
    }
    return replace_all(text, "{s}", subjects->text);
  }

  const Plan& plan_;
  Rng rng_;
  Naming naming_;
  double statement_share_;
  bool nested_;
};

}  // namespace

std::optional<std::string> realise(const Plan& plan, const NounTable& lexicon, const std::string& style, Rng rng) {
  return Realiser(plan, lexicon, style, rng).text();
}

}  // namespace unietp
