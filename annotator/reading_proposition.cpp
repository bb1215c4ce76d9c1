#include "annotator/reading_proposition.h"

#include <utility>

#include "core/limits.h"

namespace unietp {
namespace {

using Op = Formula::Op;

class PropositionReader {
 public:
  explicit PropositionReader(PhraseReader& words) : words_(words) {}

  /// `later`: read at some later point than the start, which has other words for time.
  Proposition read(bool later) {
    Proposition said;
    if (words_.failed()) return said;
    if (++depth_ > limits::kFormulaDepth) {
      words_.fail("expected less nesting");
    } else if (!over_time(said, later) && !of_several(said, later) && !bound(said, later)) {
      fact(said);
    }
    --depth_;
    return said;
  }

 private:
  void operands(Proposition& said, Op op, bool later) {
    said.op = op;
    said.parts.push_back(read(later));
  }

  void two(Proposition& said, Op op, std::initializer_list<std::string_view> links, bool later) {
    operands(said, op, later);
    if (words_.accept_one(links) < 0) words_.fail("expected '" + std::string(*links.begin()) + "'");
    said.parts.push_back(read(later));
  }

  bool over_time(Proposition& said, bool later) {
    if (words_.accept_one({"at the end ,", "in the end ,"}) >= 0) {
      operands(said, Op::AtEnd, true);
    } else if (later ? words_.accept("at that time or later ,")
                     : words_.accept_one({"at some point ,", "at one time or another ,"}) >= 0) {
      operands(said, Op::Sometime, true);
    } else if (later ? words_.accept("from then on ,")
                     : words_.accept_one({"at all times ,", "the whole time ,"}) >= 0) {
      operands(said, Op::Always, true);
    } else if (words_.accept("until")) {
      two(said, Op::Until, {","}, true);
      std::swap(said.parts[0], said.parts[1]);
    } else if (words_.accept("first")) {
      two(said, Op::Before, {", and only later", ", and only after that"}, true);
    } else {
      return false;
    }
    return true;
  }

  bool of_several(Proposition& said, bool later) {
    if (words_.accept("both")) {
      two(said, Op::And, {", and"}, later);
    } else if (words_.accept("either")) {
      two(said, Op::Or, {", or"}, later);
    } else if (words_.accept("if")) {
      two(said, Op::Imply, {", then"}, later);
    } else if (words_.accept("it is not so that")) {
      operands(said, Op::Not, later);
    } else if (words_.accept("anything goes")) {
      said.op = Op::And;
    } else if (words_.accept("the impossible happens")) {
      said.op = Op::Or;
    } else if (words_.accept("all")) {
      many(said, Op::And, "of these hold :", ", and", later);
    } else if (words_.accept("at least one of these")) {
      many(said, Op::Or, "holds :", ", or", later);
    } else {
      return false;
    }
    return true;
  }

  void many(Proposition& said, Op op, std::string_view words, std::string_view last, bool later) {
    said.op = op;
    const int count = words_.number();
    words_.expect(words);
    for (int i = 0; i < count && !words_.failed(); ++i) {
      if (i > 0) words_.expect(i + 1 < count ? "," : last);
      said.parts.push_back(read(later));
    }
  }

  bool bound(Proposition& said, bool later) {
    if (words_.accept("there are")) {
      compared(said, later);
    } else if (words_.accept("there is")) {
      said.op = Op::Exists;
      noun(said, words_.phrase());
      if (said.phrases[0].determiner != Determiner::New) words_.fail("expected 'some …' before this");
      said.parts.emplace_back();
    } else if (words_.accept("for")) {
      noun(said, words_.phrase());
      said.op = quantifier(said.phrases[0].determiner);
      words_.expect(",");
      said.parts.push_back(read(later));
    } else {
      return false;
    }
    return true;
  }

  void noun(Proposition& said, NounPhrase phrase) {
    said.phrases.push_back(std::move(phrase));
    if (words_.accept("for which at the start")) said.where.push_back(read(false));
  }

  Op quantifier(Determiner determiner) {
    switch (determiner) {
      case Determiner::New:
        return Op::Exists;
      case Determiner::Every:
        return Op::Forall;
      case Determiner::Exactly:
      case Determiner::AtLeast:
      case Determiner::AtMost:
        return Op::Count;
      default:
        words_.fail("expected 'some', 'every' or a number before this");
        return Op::Exists;
    }
  }

  void compared(Proposition& said, bool later) {
    static constexpr std::pair<std::string_view, Comparison> kQuantities[] = {{"more", Comparison::Greater},
                                                                              {"fewer", Comparison::Less},
                                                                              {"as many", Comparison::Equal},
                                                                              {"at least as many", Comparison::AtLeast},
                                                                              {"at most as many", Comparison::AtMost}};
    said.op = Op::CountCompare;
    bool found = false;
    for (const auto& [words, comparison] : kQuantities) {
      if (found || !words_.accept(words)) continue;
      said.comparison = comparison;
      found = true;
    }
    if (!found) words_.fail("expected 'more', 'fewer' or 'as many'");
    const bool unequal = said.comparison == Comparison::Greater || said.comparison == Comparison::Less;
    said.parts.push_back(number(later));
    words_.expect(unequal ? ", than" : ", as");
    said.parts.push_back(number(later));
  }

  Proposition number(bool later) {
    Proposition side;
    side.op = Op::Number;
    noun(side, words_.bare_noun());
    if (!side.where.empty()) words_.expect(",");
    words_.expect("such that");
    side.parts.push_back(read(later));
    return side;
  }

  void fact(Proposition& said) {
    said.op = Op::Atom;
    said.phrases.push_back(words_.phrase());
    if (words_.accept_one({"is", "are"}) < 0) words_.fail("expected 'is' or 'are'");
    const int same = words_.accept_one({"the same thing as", "not the same thing as"});
    if (same < 0) {
      said.said.push_back(words_.complement());
      return;
    }
    said.op = Op::Equal;
    said.negated = same == 1;
    said.phrases.push_back(words_.phrase());
  }

  PhraseReader& words_;
  int depth_ = 0;
};

}  // namespace

Proposition read_proposition(PhraseReader& words) { return PropositionReader(words).read(false); }

}  // namespace unietp
