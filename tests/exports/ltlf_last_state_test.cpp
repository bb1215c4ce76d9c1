// What formulas ask of the last state: against the formula itself on every trace of two states, by a reader of the
// tests.
#include "exports/ltlf_last_state.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "ltlf_reader.h"

namespace unietp::testing {
namespace {

const std::map<std::string, std::string>& literals() {
  static const std::map<std::string, std::string> kLiterals{
      {"a", "(open ?a)"}, {"b", "(hot ?b)"}, {"exists_c", "(real ?c)"}};
  return kLiterals;
}

LastState asked(const std::string& formula) {
  return last_state_of(formula, literals(), [](const std::string& name) { return name.starts_with("exists_"); });
}

/// Truth of such a BDDL formula among literals.
bool holds_in(const std::string& text, std::size_t& at, const std::set<std::string>& facts) {
  for (const std::string word : {"and", "or", "not"}) {
    if (text.compare(at, word.size() + 2, "(" + word + " ") != 0) continue;
    at += word.size() + 2;
    std::vector<bool> parts;
    while (text[at] != ')') {
      parts.push_back(holds_in(text, at, facts));
      if (text[at] == ' ') ++at;
    }
    ++at;
    if (word == "not") return !parts.at(0);
    const auto met = static_cast<std::size_t>(std::count(parts.begin(), parts.end(), true));
    return word == "and" ? met == parts.size() : met > 0;
  }
  if (text == "true" || text == "false") return text == "true";
  const auto end = text.find(')', at) + 1;
  const auto literal = text.substr(at, end - at);
  at = end;
  return facts.contains(literal);
}

/// All traces of two states over a, b and exists_c, which once true stays true.
std::vector<LtlfTrace> traces() {
  std::vector<LtlfTrace> all;
  for (unsigned bits = 0; bits < 64; ++bits) {
    LtlfTrace trace(2);
    for (unsigned i = 0; i < 6; ++i) {
      static const std::vector<std::string> kNames{"a", "b", "exists_c"};
      if ((bits >> i & 1U) != 0) trace[i / 3].insert(kNames[i % 3]);
    }
    if (trace[0].contains("exists_c") && !trace[1].contains("exists_c")) continue;
    all.push_back(trace);
  }
  return all;
}

TEST(LastState, WhatIsAskedIsNecessaryAndDecidesWhereItSaysSo) {
  const std::map<std::string, bool> formulas{
      // whether the last state decides
      {"G(F(a))", true},
      {"G(F((a) & (!(b))))", true},
      {"(G(F(a))) | (!(G(F(b))))", true},
      {"(F(exists_c)) & (G(F(a)))", true},
      {"(!(F(exists_c))) | (G(F((a) | (b))))", true},
      {"G(a)", false},
      {"F(a)", false},
      {"!(G(a))", false},
      {"(!(F(a))) & (G(F(b)))", false},
      {"((!(b)) U ((a) & (!(b)))) & (F(b)) & (G(F((a) & (b))))", false},
      {"!((a) U (b))", false},
      {"a", false},
      {"true", true},
  };
  for (const auto& [formula, decides] : formulas) {
    const LastState last = asked(formula);
    EXPECT_EQ(last.decides, decides) << formula;
    for (const LtlfTrace& trace : traces()) {
      std::set<std::string> facts;
      for (const auto& name : trace.back()) facts.insert(literals().at(name));
      std::size_t at = 0;
      const bool met = holds_in(last.text, at, facts), ours = ltlf_holds(formula, trace);
      EXPECT_TRUE(decides ? met == ours : met || !ours) << formula << " gives " << last.text;
    }
  }
  EXPECT_EQ(asked("(!(F(a))) & (G(F(b)))").text, "(and (not (open ?a)) (hot ?b))");
  EXPECT_EQ(asked("((!(b)) U ((a) & (!(b)))) & (F(b)) & (G(F((a) & (b))))").text, "(and (open ?a) (hot ?b))");
}

}  // namespace
}  // namespace unietp::testing
