#include "annotator/realize_proposition.h"

#include "core/text.h"

namespace unietp {
namespace {

using Op = Formula::Op;
using Text = std::optional<std::string>;

class PropositionWriter {
 public:
  PropositionWriter(Naming& naming, Rng& rng) : naming_(naming), rng_(rng) {}

  /// `later`: read at some later point than the start.
  Text of(const Proposition& said, bool later) {
    switch (said.op) {
      case Op::Atom:
        return atom(said);
      case Op::Equal:
        return same(said);
      case Op::And:
        return joined(said, later, "both ", ", and ", "all ", " of these hold: ", "anything goes");
      case Op::Or:
        return joined(said, later, "either ", ", or ", "at least one of these ", " holds: ", "the impossible happens");
      case Op::Not:
        return before("it is not so that ", said, 0, later);
      case Op::Imply:
        return linked("if ", said, 0, ", then ", 1, later);
      case Op::Exists:
        if (is_true(said.parts[0])) return binder("there is ", said, 0, later, nullptr);
        [[fallthrough]];
      case Op::Forall:
      case Op::Count:
        return binder("for ", said, 0, later, ", ");
      case Op::CountCompare:
        return comparison(said, later);
      case Op::Number:
        return std::nullopt;  // part of a comparison
      case Op::AtEnd:
        return before(pick({"at the end, ", "in the end, "}), said, 0, true);
      case Op::Sometime:
        return before(later ? "at that time or later, " : pick({"at some point, ", "at one time or another, "}), said,
                      0, true);
      case Op::Always:
        return before(later ? "from then on, " : pick({"at all times, ", "the whole time, "}), said, 0, true);
      case Op::Until:
        return linked("until ", said, 1, ", ", 0, true);
      case Op::Before:
        return linked("first ", said, 0, pick({", and only later ", ", and only after that "}), 1, true);
    }
    return std::nullopt;
  }

 private:
  std::string pick(std::initializer_list<const char*> choices) {
    return *(choices.begin() + rng_.below(choices.size()));
  }

  static bool is_true(const Proposition& said) { return said.op == Op::And && said.parts.empty(); }

  Text before(const std::string& words, const Proposition& said, std::size_t part, bool later) {
    const Text text = of(said.parts[part], later);
    return text ? Text(words + *text) : std::nullopt;
  }

  Text linked(const std::string& words, const Proposition& said, std::size_t first, const std::string& link,
              std::size_t second, bool later) {
    const Text one = of(said.parts[first], later);
    const Text other = one ? of(said.parts[second], later) : std::nullopt;
    return other ? Text(words + *one + link + *other) : std::nullopt;
  }

  /// "both a, and b"; "all three of these hold: a, b, and c"
  Text joined(const Proposition& said, bool later, const std::string& two, const std::string& link,
              const std::string& many, const std::string& many_end, const char* none) {
    if (said.parts.empty()) return none;
    if (said.parts.size() == 2) return linked(two, said, 0, link, 1, later);
    std::string text = many + number_word(static_cast<int>(said.parts.size())) + many_end;
    for (std::size_t i = 0; i < said.parts.size(); ++i) {
      const Text part = of(said.parts[i], later);
      if (!part) return std::nullopt;
      if (i > 0) text += i + 1 < said.parts.size() ? ", " : link;
      text += *part;
    }
    return text;
  }

  Text atom(const Proposition& said) {
    const auto subject = naming_.phrase(said.phrases[0], {.exact = true});
    const Text what = subject ? naming_.complement(said.said[0], {.exact = true}) : std::nullopt;
    return what ? Text(subject->text + (subject->plural ? " are " : " is ") + *what) : std::nullopt;
  }

  Text same(const Proposition& said) {
    const auto one = naming_.phrase(said.phrases[0], {.exact = true});
    const auto other = naming_.phrase(said.phrases[1], {.exact = true});
    if (!one || !other) return std::nullopt;
    return one->text + (said.negated ? " is not" : " is") + " the same thing as " + other->text;
  }

  Text where(const Proposition& said) {
    if (said.where.empty()) return "";
    const Text text = of(said.where[0], false);
    return text ? Text(" for which at the start " + *text) : std::nullopt;
  }

  /// "for every mug, …"; without a link the rest goes unsaid.
  Text binder(const std::string& words, const Proposition& said, std::size_t part, bool later, const char* link) {
    const std::size_t outside = naming_.named_count();
    const auto bound = naming_.phrase(said.phrases[0], {.exact = true});
    const Text restricted = bound ? where(said) : std::nullopt;
    const Text body = !restricted ? std::nullopt : link == nullptr ? Text("") : of(said.parts[part], later);
    naming_.forget_after(outside);
    if (!body) return std::nullopt;
    return words + bound->text + *restricted + (link == nullptr ? "" : link) + *body;
  }

  /// "there are more mugs such that …, than plates such that …"
  Text comparison(const Proposition& said, bool later) {
    const auto [quantity, link] = [&]() -> std::pair<const char*, const char*> {
      switch (said.comparison) {
        case Comparison::Equal:
          return {"as many ", "as "};
        case Comparison::AtLeast:
          return {"at least as many ", "as "};
        case Comparison::AtMost:
          return {"at most as many ", "as "};
        case Comparison::Greater:
          return {"more ", "than "};
        case Comparison::Less:
          break;
      }
      return {"fewer ", "than "};
    }();
    std::string text = std::string("there are ") + quantity;
    for (std::size_t i = 0; i < 2; ++i) {
      const Proposition& side = said.parts[i];
      const std::size_t outside = naming_.named_count();
      const Text many = naming_.plural(side.phrases[0], {.exact = true});
      const Text restricted = many ? where(side) : std::nullopt;
      const Text body = restricted ? of(side.parts[0], later) : std::nullopt;
      naming_.forget_after(outside);
      if (!body) return std::nullopt;
      if (i > 0) text += std::string(", ") + link;
      text += *many + *restricted + (side.where.empty() ? "" : ",") + " such that " + *body;
    }
    return text;
  }

  Naming& naming_;
  Rng& rng_;
};

}  // namespace

std::optional<std::string> proposition_words(const Proposition& said, Naming& naming, Rng& rng) {
  return PropositionWriter(naming, rng).of(said, false);
}

}  // namespace unietp
