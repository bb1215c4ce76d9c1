#include "annotator/opposite_check.h"

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <string_view>

#include "annotator/goal_words.h"
#include "annotator/naming.h"
#include "annotator/words_for_reading.h"

namespace unietp {
namespace {

using P = Predicate;
using Op = Formula::Op;
using Tokens = std::vector<Token>;

/// How a goal uses its predicates, and which of its operators have an opposite.
struct Uses {
  std::set<P> asked, denied;
  std::set<P> told;                       // in `:where` and in premises
  std::set<std::string> sizes;            // "large", "small"
  bool bounds = false, compares = false;  // at most, none; two counts
  bool counts = false, either = false;    // any count; a choice
  std::vector<const Formula*> orders;     // before, until
};

void collect_told(const Formula& f, Uses& uses) {
  if (f.op == Op::Atom) {
    uses.told.insert(f.predicate);
    if (f.predicate == P::Size) uses.sizes.insert(f.terms.back().name);
  }
  for (const Formula& where : f.domain.where) collect_told(where, uses);
  for (const Formula& child : f.children) collect_told(child, uses);
}

void collect(const Formula& f, bool denied, Uses& uses) {
  if (f.op == Op::Atom) (denied ? uses.denied : uses.asked).insert(f.predicate);
  for (const Formula& where : f.domain.where) collect_told(where, uses);
  uses.either |= f.op == Op::Or || f.op == Op::Imply || f.domain.members.size() > 1;
  uses.counts |= f.op == Op::Count || f.op == Op::CountCompare;
  uses.compares |= f.op == Op::CountCompare;
  const bool upper = f.op == Op::Count && (f.comparison == Comparison::AtMost || f.comparison == Comparison::Less);
  const bool zero = f.op == Op::Count && f.number == 0 && f.comparison == Comparison::Equal;
  uses.bounds |= upper || zero;
  if (f.op == Op::Before || f.op == Op::Until) uses.orders.push_back(&f);
  for (std::size_t i = 0; i < f.children.size(); ++i) {
    if (f.op == Op::Imply && i == 0) {
      collect_told(f.children[0], uses);
    } else {
      collect(f.children[i], denied != (f.op == Op::Not || zero), uses);
    }
  }
}

bool is_number(const std::string& word) {
  constexpr int kMost = 12;
  for (int number = 1; number <= kMost; ++number)
    if (word == number_word(number) || word == std::to_string(number)) return true;
  return false;
}

/// Where a clause ends: no verb of it speaks of what comes behind.
bool ends_clause(const Tokens& words, std::size_t i) {
  return i >= words.size() ||
         is_among(words[i].text, ", ; ! ? : and. then. before. after. when. until. once. while. but. or. if. so.") ||
         words[i].text == ".";
}

class Opposites {
 public:
  Opposites(const Tokens& words, const Specification& specification)
      : words_(words), specification_(specification), goal_(words_of_goal(specification.goal)) {
    collect(specification.goal, false, uses_);
  }

  std::vector<std::string> faults() {
    if (specification_.style != Style::Request && specification_.style != Style::Condition) {
      switching();
      removal();
      pouring();
      nearness();
    }
    sizes();
    bounds();
    nothing();
    choice();
    if (!tells_a_story()) {  // "All my friends are coming", "last night"
      everything();
      last();
    }
    if (uses_.orders.size() == 1) order(*uses_.orders.front());
    premises();
    return std::move(faults_);
  }

 private:
  std::string_view word(std::size_t i) const { return i < words_.size() ? std::string_view(words_[i].text) : ""; }
  bool any(std::string_view list) const {
    return std::any_of(words_.begin(), words_.end(), [&](const Token& one) { return is_among(one.text, list); });
  }
  bool knows(P predicate) const {
    return uses_.asked.contains(predicate) || uses_.denied.contains(predicate) || uses_.told.contains(predicate);
  }
  void lacks(const std::string& what) { faults_.push_back("the text does not say " + what); }
  void exceeds(const std::string& what) { faults_.push_back("the text asks for more than the goal: " + what); }

  /// Whether a text of the style says more than what is asked.
  bool tells_a_story() const {
    constexpr std::array kWithStories{Style::Aside,        Style::Context,   Style::Request,
                                      Style::ImplicitNeed, Style::Condition, Style::Distractor};
    return std::find(kWithStories.begin(), kWithStories.end(), specification_.style) != kWithStories.end();
  }

  /// Whether a verb of switching precedes in the same clause.
  bool is_switched(std::size_t at) const {
    for (std::size_t i = at; i-- > 0 && !ends_clause(words_, i);)
      if (is_among(words_[i].text, "turn switch power. powered. powering. shut flip click")) return true;
    return false;
  }
  /// "Turn on the lamp", "turn the lamp on the desk off", "leave it off": not "on the desk", "off the table".
  bool switches(std::string_view particle) const {
    for (std::size_t i = 1; i < words_.size(); ++i) {
      if (words_[i].text != particle) continue;
      const bool leads_on = is_among(
          word(i + 1),
          "the. a. an. one. my. your. our. its. their. this. that. top. of. it. them. both. all. each. every. some.");
      const bool by_verb = is_among(word(i - 1), "turn switch power. powered. powering. shut flip click");
      if (by_verb || (is_switched(i) && (!leads_on || particle == "off"))) return true;
      if (particle != "on" && particle != "off") continue;  // "take the mug out"
      if (ends_clause(words_, i + 1) || is_among(word(i + 1), "again. first. last. please. now. too. for. at. later."))
        return true;
    }
    return false;
  }

  void switching() {
    if (!knows(P::PowerOn) && !knows(P::PowerOff)) return;
    const auto allowed = [&](P one, P other) {
      return uses_.asked.contains(one) || uses_.told.contains(one) || uses_.denied.contains(other);
    };
    const bool says_on = switches("on") || any("start. starts. starting. run. running. lit. light. activate");
    const bool says_off =
        switches("off") || switches("out") || switches("down") || any("stop. stops. stopping. deactivate");
    if (says_off && !allowed(P::PowerOff, P::PowerOn)) exceeds("'off'");
    if (switches("on") && !allowed(P::PowerOn, P::PowerOff)) exceeds("'on'");
    if (uses_.asked.contains(P::PowerOn) && !says_on) lacks("'on'");
    if (uses_.asked.contains(P::PowerOff) && !says_off) lacks("'off'");
  }

  /// "Take it off the table" where it is to be put on the table.
  void removal() {
    const auto speaks_of_place = [](const std::set<P>& all) {
      constexpr std::array kPlaces{P::On, P::Inside, P::OnFloor, P::InRoom, P::NextTo, P::Under, P::Nearest};
      return std::any_of(kPlaces.begin(), kPlaces.end(), [&](P place) { return all.contains(place); });
    };
    if (!speaks_of_place(uses_.asked) || speaks_of_place(uses_.denied) || speaks_of_place(uses_.told)) return;
    for (std::size_t i = 1; i < words_.size(); ++i)
      if (words_[i].text == "off" && is_put(i)) return exceeds("'off'");
    if (uses_.bounds || knows(P::Covered) || knows(P::Empty) || knows(P::Clean) || knows(P::SliceOf)) return;
    for (std::size_t i = 1; i < words_.size(); ++i) {
      const bool off = words_[i].text == "off" && !is_switched(i) && !ends_clause(words_, i + 1) &&
                       !is_among(words_[i - 1].text, "start. starting.");
      const bool out = words_[i].text == "out" && word(i + 1) == "of" && words_[i - 1].text != "made" && !is_for_use(i);
      const bool from = words_[i].text == "from" && is_taken(i) && is_among(word(i + 1), "the. a. an. your. my. that.");
      if (off || out || from) return exceeds("'" + words_[i].text + "'");
    }
  }
  /// "Something to drink out of", "to eat soup out of": no more than three words after "to".
  bool is_for_use(std::size_t at) const {
    for (std::size_t back = 1; back <= 3 && back < at; ++back)
      if (is_among(words_[at - back].text, "drink. eat.") && words_[at - back - 1].text == "to") return true;
    return false;
  }
  /// Whether a verb of taking precedes in the same clause, with a list of things in between.
  bool is_taken(std::size_t at) const {
    for (std::size_t i = at; i-- > 0 && (words_[i].text == "and" || !ends_clause(words_, i));)
      if (is_among(words_[i].text, "take. remove. get. grab. fetch. pull. clear. taking. removing. getting."))
        return true;
    return false;
  }

  /// Whether a verb of putting precedes in the same clause: "place it off the counter".
  bool is_put(std::size_t at) const {
    for (std::size_t i = at; i-- > 0 && !ends_clause(words_, i);)
      if (is_among(words_[i].text, "put. place. set. putting. placing. setting.")) return true;
    return false;
  }

  /// "Pour water out of the pot", or over it, where it is to be filled.
  void pouring() {
    if (!uses_.asked.contains(P::Filled) || knows(P::Empty)) return;
    for (std::size_t verb = 0; verb < words_.size(); ++verb) {
      if (!is_among(words_[verb].text, "pour. pouring.")) continue;
      std::string_view wrong;
      bool fills = false;
      for (std::size_t i = verb + 1; !ends_clause(words_, i); ++i) {
        fills = fills || is_among(words_[i].text, "in. into. inside. to.");
        if (is_among(words_[i].text, "from. out. over. off.")) wrong = words_[i].text;
      }
      if (!wrong.empty() && !fills) return exceeds("'" + std::string(wrong) + "'");
    }
  }

  /// "Put it next to the plate" where it is to be on the plate.
  void nearness() {
    if (knows(P::NextTo) || knows(P::Nearest)) return;
    if (says({"next", "to"}) || any("beside.")) exceeds("'next to'");
  }

  void sizes() {
    constexpr std::string_view kLarge = "larg big", kSmall = "small tiny tini little.";
    if (uses_.sizes.size() != 1) return;
    const bool large = uses_.sizes.contains("large");
    if (!large && !uses_.sizes.contains("small")) return;
    if (!any(large ? kLarge : kSmall)) lacks(large ? "'large'" : "'small'");
    if (any(large ? kSmall : kLarge)) exceeds(large ? "'small'" : "'large'");
  }

  bool says(std::initializer_list<std::string_view> phrase) const {
    for (std::size_t i = 0; i + phrase.size() <= words_.size(); ++i)
      if (std::equal(phrase.begin(), phrase.end(), words_.begin() + static_cast<std::ptrdiff_t>(i),
                     [](std::string_view one, const Token& token) { return one == token.text; }))
        return true;
    return false;
  }

  /// "Up to two", not "which ones is up to you".
  bool says_up_to_a_number() const {
    for (std::size_t i = 0; i + 2 < words_.size(); ++i)
      if (words_[i].text == "up" && words_[i + 1].text == "to" && is_number(words_[i + 2].text)) return true;
    return false;
  }

  /// "At most two", where two or more are wanted, and the other way around.
  void bounds() {
    if (!uses_.counts || uses_.compares) return;
    const bool upper = says({"at", "most"}) || says({"no", "more", "than"}) || says({"not", "more", "than"}) ||
                       says_up_to_a_number() || any("maximum. fewer. less.");
    const bool not_fewer =
        says({"no", "fewer"}) || says({"no", "less"}) || says({"not", "fewer"}) || says({"not", "less"});
    const bool lower = says({"at", "least"}) || says({"or", "more"}) || any("minimum.") || not_fewer;
    if (upper && !not_fewer && !uses_.bounds && !goal_.at_most) exceeds("'at most'");
    if (lower && goal_.at_most && !goal_.at_least) exceeds("'at least'");
  }

  /// "None of the mugs", where nothing is denied.
  void nothing() {
    if (!uses_.denied.empty() || uses_.bounds || goal_.none || goal_.at_most || uses_.compares) return;
    for (std::size_t i = 0; i < words_.size(); ++i) {
      const bool no =
          words_[i].text == "no" &&
          !is_among(word(i + 1),
                    "fewer. less. more. later. longer. matter. other. others. further. need. rush. hurry. problem.");
      const bool none = words_[i].text == "none" || words_[i].text == "neither" || words_[i].text == "zero";
      const bool others = word(i + 1) == "of" && is_among(word(i + 3), "other. others. rest.");
      if (no || (none && !others)) return exceeds("'" + words_[i].text + "'");
    }
    // What is asked of every one is not asked by "do not".
    if (!goal_.every || goal_.order || goal_.throughout) return;
    for (std::size_t i = 0; i < words_.size(); ++i) {
      const bool denial = is_among(words_[i].text, "not. don't. never.");
      const bool only_spurs = is_among(word(i + 1), "forget. leave. miss. skip. stop. just. only. mind.");
      const bool of_if = i > 0 && words_[i - 1].text == "if";
      if (denial && !only_spurs && !of_if && !tells_exception(i)) return exceeds("'" + words_[i].text + "'");
    }
  }
  /// "All the mugs, not the red one", "that are not red".
  bool tells_exception(std::size_t at) const {
    return !uses_.told.empty() &&
           (is_among(word(at + 1), "the. in. on. inside. made. next.") || uses_.told.size() > 1 ||
            (at > 0 && is_among(words_[at - 1].text, "are. is. that. which. aren't. isn't.")));
  }

  /// "All the mugs", where one will do. Of several that are counted all may be there are.
  void everything() {
    if (goal_.every || goal_.none || uses_.counts || goal_.throughout) return;
    for (std::size_t i = 0; i < words_.size(); ++i)
      if (words_[i].text == "all" && is_among(word(i + 1), "the. of. my. your. our. these. those.") &&
          !is_among(word(i + 2), "time. way. while. it. that. this."))
        return exceeds("'all'");
  }

  /// Whether the goal is one of several things that may be done: not what is only expected on a condition.
  static bool chooses(const Formula& f) {
    if (f.op == Op::Exists || f.op == Op::AtEnd) return chooses(f.children[0]);
    return f.op == Op::Or && f.children.size() > 1 &&
           std::all_of(f.children.begin(), f.children.end(), [](const Formula& part) { return part.op == Op::Exists; });
  }

  /// "The mug or the plate", where both are wanted, and "the mug and the plate", where one is.
  void choice() {
    const bool by_case = !uses_.told.empty() && any("if. when.");
    if (chooses(specification_.goal) && !by_case && !any("or. either. one. whichever. alternatively. nor."))
      lacks("'or'");
    if (tells_a_story() || uses_.either || goal_.at_least || goal_.at_most || goal_.none) return;
    for (std::size_t i = 0; i < words_.size(); ++i)
      if (words_[i].text == "or" && !is_among(word(i + 1), "so. not. more. else.")) return exceeds("'or'");
  }

  /// "Last wash the mug, then put it away."
  void last() {
    for (std::size_t i = 0; i < words_.size(); ++i) {
      if (words_[i].text != "last" && words_[i].text != "lastly" && words_[i].text != "finally") continue;
      if (i > 0 && is_among(words_[i - 1].text, "the. at. very. its.")) continue;
      for (std::size_t k = i + 1; k < words_.size(); ++k)
        if (is_among(words_[k].text, "then. next. afterwards. afterward. first. after. later.") &&
            !(words_[k].text == "next" && word(k + 1) == "to"))
          return exceeds("'" + words_[i].text + "' before '" + words_[k].text + "'");
      if (!goal_.order && words_[i].text != "finally") return exceeds("'" + words_[i].text + "'");
    }
  }

  /// Words by which a text speaks of one of two parts of an order, and not of the other; "" when nothing tells them
  /// apart.
  std::string_view cue(const Formula& part, const Formula& other) const {
    const auto mine = words_of_goal(part).predicates, theirs = words_of_goal(other).predicates;
    const auto is_switching = [](P one) { return one == P::PowerOn || one == P::PowerOff; };
    for (const P predicate : mine) {
      if (theirs.contains(predicate) || uses_.told.contains(predicate)) continue;
      if (is_switching(predicate)) {
        if (std::any_of(theirs.begin(), theirs.end(), is_switching)) continue;  // "turn" says either
        return "turn. turning. turned. switch. switching. switched.";
      }
      if (predicate == P::On || predicate == P::Inside || predicate == P::InRoom || predicate == P::NextTo ||
          predicate == P::OnFloor)
        return "put. place. set. bring. move. putting. placing. setting. bringing. moving. store. carry.";
      if (predicate == P::Sliced) return "cut. cutting. slice. slicing. sliced. chop. chopping. chopped.";
      if (!words_only_for(predicate).empty()) return words_only_for(predicate);
    }
    return "";
  }

  std::optional<std::size_t> first_of(std::string_view list) const {
    for (std::size_t i = 0; i < words_.size(); ++i)
      if (is_among(words_[i].text, list)) return i;
    return std::nullopt;
  }

  /// Whether what is named first comes first; nullopt where no word tells, or two do and differ.
  std::optional<bool> is_in_order(std::size_t first, std::size_t second) const {
    bool forward = false, backward = false, same_clause = true;
    for (std::size_t i = 0; i < words_.size() && (i <= second || !ends_clause(words_, i)); ++i) {
      const auto& said = words_[i].text;
      const bool opens = i == 0 || words_[i - 1].text == ".", joins = said == "once" || said == "when";
      const bool of_that = is_among(word(i + 1), "that. this. which.");
      same_clause &= i <= first || !ends_clause(words_, i);
      const bool of_first = i < first || same_clause;  // "first" and "last" are of what is named in their clause
      forward |= said == (of_first ? "first" : "last");
      backward |= said == (of_first ? "last" : "first");
      if (i < first) {
        forward |= (said == "after" && !of_that) || joins;
        backward |= said == "before" && !of_that;
      } else if (i < second) {
        forward |= is_among(said, "then. next. afterwards. afterward. later. finally.") ||
                   (said == (of_that ? "after" : "before")) || (opens && joins);
        backward |= said == (of_that ? "before" : "after") || (!opens && joins);
      }
    }
    if (forward == backward) return std::nullopt;
    return forward;
  }

  void order(const Formula& formula) {
    if (formula.op != Op::Before) return;
    const auto early = first_of(cue(formula.children[0], formula.children[1])),
               late = first_of(cue(formula.children[1], formula.children[0]));
    if (!early || !late || *early == *late) return;
    const auto in_order = is_in_order(std::min(*early, *late), std::max(*early, *late));
    if (in_order && *in_order != (*early < *late)) lacks("the order: what comes first is said to come last");
  }

  /// Words that only one of two branches of a choice has: of what holds where it is to be done, and of what is done.
  struct Branch {
    std::string_view when, then;
  };
  static Branch branch(const Formula& one, const Formula& other) {
    Uses mine, theirs;
    collect(one, false, mine);
    collect(other, false, theirs);
    Branch words;
    for (const P predicate : mine.told)
      if (words.when.empty() && !theirs.told.contains(predicate)) words.when = words_only_for(predicate);
    for (const P predicate : mine.asked) {
      if (!words.then.empty() || theirs.asked.contains(predicate)) continue;
      if (predicate == P::Inside) words.then = "in. into. inside.";
      words.then = predicate == P::On ? "on. onto." : words.then.empty() ? words_only_for(predicate) : words.then;
    }
    return words;
  }
  /// Which of two lists words of a clause are on; nullopt where it is neither or both.
  std::optional<bool> is_first_of(std::string_view first, std::string_view second, std::size_t begin,
                                  std::size_t end) const {
    bool has_first = false, has_second = false;
    for (std::size_t i = begin; i < end; ++i) {
      has_first |= is_among(words_[i].text, first);
      has_second |= is_among(words_[i].text, second);
    }
    if (has_first == has_second) return std::nullopt;
    return has_first;
  }
  /// "If it is closed, put the pot in it", where the pot is to be put in if it is open.
  void premises() {
    const Formula& goal = specification_.goal;
    if (goal.op != Formula::Op::Or || goal.children.size() != 2) return;
    const Branch one = branch(goal.children[0], goal.children[1]), two = branch(goal.children[1], goal.children[0]);
    if (one.when.empty() || two.when.empty() || one.then.empty() || two.then.empty()) return;
    for (std::size_t i = 0; i < words_.size(); ++i) {
      if (words_[i].text != "if") continue;
      std::size_t comma = i + 1;
      while (!ends_clause(words_, comma)) ++comma;
      std::size_t begin = i, end = i;  // what is done then: before "if", or behind the comma
      if (i == 0 || ends_clause(words_, i - 1)) {
        begin = end = std::min(comma + 1, words_.size());
        while (!ends_clause(words_, end)) ++end;
      } else {
        while (begin > 0 && !ends_clause(words_, begin - 1)) --begin;
      }
      const auto state = is_first_of(one.when, two.when, i, comma), done = is_first_of(one.then, two.then, begin, end);
      bool denied = false;
      for (std::size_t k = i; k < comma; ++k) denied |= is_among(words_[k].text, "not. isn't. aren't.");
      if (state && done && (*state != denied) != *done) return lacks("what is to be done in which case");
    }
  }

  const Tokens& words_;
  const Specification& specification_;
  GoalWords goal_;
  Uses uses_;
  std::vector<std::string> faults_;
};

}  // namespace

std::vector<std::string> opposite_faults(const std::vector<Token>& words, const Specification& specification) {
  return Opposites(words, specification).faults();
}

}  // namespace unietp
