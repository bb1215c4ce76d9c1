#include "akb/phrases.h"

#include <algorithm>
#include <set>

#include "core/text.h"

namespace unietp {
namespace {

bool is_lower(char c) { return c >= 'a' && c <= 'z'; }
bool is_upper(char c) { return c >= 'A' && c <= 'Z'; }

/// Letters with single blanks, hyphens and apostrophes between them, and what `extra` allows anywhere.
bool are_words(std::string_view text, bool upper_too, std::string_view extra) {
  bool after_letter = false;
  for (const char c : text) {
    const bool letter = is_lower(c) || (upper_too && is_upper(c));
    const bool between = c == ' ' || c == '-' || c == '\'';
    if (extra.find(c) == std::string_view::npos) {
      if (!letter && !(between && after_letter)) return false;
      after_letter = letter;
    } else {
      after_letter = true;  // a blank may follow a comma
    }
  }
  return after_letter;
}

bool any_word_in(std::string_view text, const std::set<std::string, std::less<>>& words) {
  const auto all = split(lower(text), ' ');
  return std::any_of(all.begin(), all.end(), [&](const auto& word) { return words.contains(word); });
}

std::string_view length_between(std::string_view text, std::size_t shortest, std::size_t longest) {
  if (text.size() < shortest) return "too short";
  return text.size() > longest ? "too long" : "";
}

}  // namespace

std::string_view wrong_with_synonym(std::string_view text) {
  if (const auto wrong = length_between(text, 2, 40); !wrong.empty()) return wrong;
  return are_words(text, false, "") ? "" : "not lower-case English words";
}

std::string_view wrong_with_function(std::string_view text) {
  static const std::set<std::string, std::less<>> kHeads{"something", "somewhere", "someone", "some", "a", "an", "the"};
  if (const auto wrong = length_between(text, 8, 60); !wrong.empty()) return wrong;
  if (!are_words(text, false, "")) return "not lower-case English words";
  const auto head = text.substr(0, text.find(' '));
  return head.size() < text.size() && kHeads.contains(head) ? "" : "does not start like a function phrase";
}

std::string_view wrong_with_context(std::string_view text) {
  static const std::set<std::string, std::less<>> kEnglish{
      "i",  "i'm",  "my",  "me",    "we",   "we're",    "our",       "it",      "it's",     "is",  "the",  "are",
      "am", "have", "has", "there", "this", "somebody", "everybody", "someone", "everyone", "you", "your", "to"};
  if (const auto wrong = length_between(text, 8, 80); !wrong.empty()) return wrong;
  const auto words = text.substr(0, text.size() - 1);
  const bool ended = std::string_view(".!?").find(text.back()) != std::string_view::npos;
  if (!ended || !is_upper(text.front()) || !are_words(words, true, ",")) return "not one plain sentence";
  return any_word_in(words, kEnglish) ? "" : "not English";
}

bool names_it(std::string_view text, std::string_view words) {
  if (words.empty()) return false;
  const auto letter = [](char c) { return is_lower(c) || is_upper(c); };
  for (auto at = text.find(words); at != std::string_view::npos; at = text.find(words, at + 1)) {
    const auto end = at + words.size();
    if ((at == 0 || !letter(text[at - 1])) && (end == text.size() || !letter(text[end]))) return true;
  }
  return false;
}

}  // namespace unietp
