#include "mutations.h"

#include <algorithm>
#include <cctype>

#include "core/sexpr.h"

namespace unietp::testing_support {
namespace {

/// Bytes [from, to) of a text.
struct Span {
  std::size_t from = 0, to = 0;
};

class Spans {
 public:
  explicit Spans(std::string_view text) {
    std::vector<std::size_t> lines = {0};
    for (std::size_t i = 0; i < text.size(); ++i) {
      if (text[i] == '\n') lines.push_back(i + 1);
    }
    const auto read = read_sexprs("", text);
    if (!read) return;
    for (const auto& expression : *read) collect(expression, lines);
  }

  std::vector<Span> atoms, lists, all;

 private:
  void collect(const Sexpr& expression, const std::vector<std::size_t>& lines) {
    const auto offset = [&](SourcePos pos) {
      return lines[static_cast<std::size_t>(pos.line) - 1] + static_cast<std::size_t>(pos.column) - 1;
    };
    const Span span{offset(expression.pos), offset(expression.end) + 1};
    all.push_back(span);
    (expression.is_list() ? lists : atoms).push_back(span);
    for (const auto& child : expression.children) collect(child, lines);
  }
};

std::string text_of(const std::string& text, Span span) { return text.substr(span.from, span.to - span.from); }

void change_byte(std::string& text, Rng& rng) {
  constexpr std::string_view kBytes = "()?- :;\"\\/\n\t=<>0129aAbBxyandotw_{}\xff\xc3";
  const auto at = rng.below(text.size());
  switch (rng.below(3)) {
    case 0:
      text[at] = kBytes[rng.below(kBytes.size())];
      break;
    case 1:
      text.erase(at, 1);
      break;
    default:
      text.insert(at, 1, kBytes[rng.below(kBytes.size())]);
      break;
  }
}

void change_part(std::string& text, const std::vector<Span>& spans, Rng& rng) {
  if (spans.empty()) return;
  auto one = rng.pick(spans);
  switch (rng.below(3)) {
    case 0:
      text.erase(one.from, one.to - one.from);
      break;
    case 1:
      text.insert(one.to, " " + text_of(text, one));
      break;
    default: {
      auto other = rng.pick(spans);
      if (other.from < one.from) std::swap(one, other);
      if (other.from < one.to) return;  // one inside the other
      const auto first = text_of(text, one);
      const auto second = text_of(text, other);
      text.replace(other.from, second.size(), first);
      text.replace(one.from, first.size(), second);
      break;
    }
  }
}

void change_word(std::string& text, const Spans& spans, const std::vector<std::string>& words, Rng& rng) {
  if (spans.atoms.empty()) return;
  const auto span = rng.pick(spans.atoms);
  auto word = text_of(text, span);
  const bool number = std::all_of(word.begin(), word.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
  if (number) {
    const std::vector<std::string> others = {"0", "1", "2", "3", "02", "-1", "2x", "1e3", "99999999999", "2 2"};
    word = rng.pick(others);
  } else if (rng.below(2) == 0) {
    word = rng.pick(words);
  } else {
    const auto at = rng.below(word.size());
    const char letter = static_cast<char>('a' + rng.below(26));
    switch (rng.below(3)) {
      case 0:
        word[at] = letter;
        break;
      case 1:
        word.erase(at, 1);
        break;
      default:
        word.insert(at, 1, letter);
        break;
    }
  }
  text.replace(span.from, span.to - span.from, word);
}

}  // namespace

std::string mutated(std::string text, const std::vector<std::string>& words, Rng& rng) {
  const auto changes = 1 + rng.below(8) / 6;  // mostly one
  for (std::uint64_t i = 0; i < changes && !text.empty(); ++i) {
    const Spans spans(text);
    switch (rng.below(5)) {
      case 0:
        change_byte(text, rng);
        break;
      case 1:
        change_part(text, spans.atoms, rng);
        break;
      case 2:
        change_part(text, spans.lists, rng);
        break;
      case 3:
        change_part(text, spans.all, rng);
        break;
      default:
        change_word(text, spans, words, rng);
        break;
    }
  }
  return text;
}

std::vector<std::string> words_in(std::string_view text) {
  std::vector<std::string> words;
  const std::string copy(text);
  for (const auto& span : Spans(copy).atoms) words.push_back(text_of(copy, span));
  std::sort(words.begin(), words.end());
  words.erase(std::unique(words.begin(), words.end()), words.end());
  return words;
}

}  // namespace unietp::testing_support
