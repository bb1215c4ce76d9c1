#include "reader.h"

#include <cctype>
#include <stdexcept>

namespace unietp::testing {
namespace {

[[noreturn]] void fail(const std::string& what) { throw std::runtime_error(what); }

bool is_name(std::string_view word) {
  if (word.empty() || std::isalpha(static_cast<unsigned char>(word[0])) == 0) return false;
  for (const char c : word) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '-' && c != '_') return false;
  }
  return true;
}

const std::string& name_of(const PddlList& list) {
  if (!list.is_word() || !is_name(list.word)) fail("a name was expected, not '" + list.word + "'");
  return list.word;
}

class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) {}
  PddlList whole() {
    auto list = next();
    skip();
    if (at_ < text_.size()) fail("text after the last bracket");
    return list;
  }
  bool at_end() {
    skip();
    return at_ >= text_.size();
  }
  PddlList next() {
    skip();
    if (at_ >= text_.size()) fail("the text ends within brackets");
    PddlList list;
    if (text_[at_] == ')') fail("a bracket too many");
    if (text_[at_] != '(') {
      while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) == 0 &&
             std::string_view("();").find(text_[at_]) == std::string_view::npos)
        list.word += static_cast<char>(std::tolower(static_cast<unsigned char>(text_[at_++])));
      return list;
    }
    ++at_;
    for (skip(); at_ < text_.size() && text_[at_] != ')'; skip()) list.parts.push_back(next());
    if (at_ >= text_.size()) fail("a bracket is missing");
    ++at_;
    return list;
  }

 private:
  void skip() {
    while (at_ < text_.size()) {
      if (text_[at_] == ';') {
        while (at_ < text_.size() && text_[at_] != '\n') ++at_;
      } else if (std::isspace(static_cast<unsigned char>(text_[at_])) != 0) {
        ++at_;
      } else {
        return;
      }
    }
  }
  std::string_view text_;
  std::size_t at_ = 0;
};

bool is_headed(const PddlList& list, std::string_view word) {
  return !list.parts.empty() && list.parts[0].word == word;
}

bool descends(const PddlDomain& domain, std::string type, const std::string& from) {
  while (type != from) {
    const auto parent = domain.types.find(type);
    if (type == "object" || parent == domain.types.end()) return false;
    type = parent->second;
  }
  return true;
}

/// Checks formulas and effects: what stands where, and of which type.
class Checker {
 public:
  Checker(const PddlDomain& domain, const std::map<std::string, std::string>& objects)
      : domain_(domain), scope_(objects) {}

  void declare(const std::vector<PddlVariable>& variables) {
    for (const auto& variable : variables) {
      if (domain_.types.count(variable.type) == 0) fail("unknown type " + variable.type);
      scope_[variable.name] = variable.type;
    }
  }

  void atom(const PddlList& list) const {
    if (list.parts.empty()) fail("an empty atom");
    const auto predicate = domain_.predicates.find(name_of(list.parts[0]));
    if (predicate == domain_.predicates.end()) fail("undeclared predicate " + list.parts[0].word);
    if (predicate->second.size() + 1 != list.parts.size()) fail("wrong number of arguments of " + list.parts[0].word);
    for (std::size_t i = 1; i < list.parts.size(); ++i) {
      const auto term = scope_.find(list.parts[i].word);
      if (term == scope_.end()) fail("undeclared " + list.parts[i].word + " in " + list.parts[0].word);
      // A variable of a wider type may stand for an object of the narrower one; of a type beside it, never.
      const auto& wanted = predicate->second[i - 1].type;
      if (!descends(domain_, term->second, wanted))
        fail(term->first + " is no " + wanted + " in " + list.parts[0].word);
    }
  }

  void condition(const PddlList& list) const {
    if (is_headed(list, "and") || is_headed(list, "or")) {
      if (list.parts[0].word == "or") need(":disjunctive-preconditions");
      for (std::size_t i = 1; i < list.parts.size(); ++i) condition(list.parts[i]);
    } else if (is_headed(list, "not")) {
      if (list.parts.size() != 2) fail("not takes one formula");
      need(":negative-preconditions");
      condition(list.parts[1]);
    } else if (is_headed(list, "=")) {
      need(":equality");
      for (std::size_t i = 1; i < 3; ++i) {
        if (list.parts.size() != 3 || scope_.count(list.parts[i].word) == 0) fail("= takes two declared terms");
      }
    } else if (is_headed(list, "forall")) {
      need(":universal-preconditions");
      if (list.parts.size() != 3) fail("forall takes variables and a condition");
      Checker inner = *this;
      inner.declare(pddl_variables(list.parts[1], 0, true));
      inner.condition(list.parts[2]);
    } else {
      atom(list);
    }
  }

  void effect(const PddlList& list) {
    if (is_headed(list, "and")) {
      for (std::size_t i = 1; i < list.parts.size(); ++i) effect(list.parts[i]);
    } else if (is_headed(list, "not")) {
      if (list.parts.size() != 2) fail("not takes one atom");
      atom(list.parts[1]);
    } else if (is_headed(list, "when")) {
      need(":conditional-effects");
      if (list.parts.size() != 3) fail("when takes a condition and an effect");
      condition(list.parts[1]);
      for (const auto& part : is_headed(list.parts[2], "and") ? list.parts[2].parts : std::vector{list.parts[2]}) {
        if (part.word == "and") continue;
        if (is_headed(part, "when") || is_headed(part, "forall")) fail("within when stand only literals");
        effect(part);
      }
    } else if (is_headed(list, "forall")) {
      need(":conditional-effects");
      if (list.parts.size() != 3) fail("forall takes variables and an effect");
      const auto outer = scope_;
      declare(pddl_variables(list.parts[1], 0, true));
      effect(list.parts[2]);
      scope_ = outer;
    } else {
      atom(list);
    }
  }

 private:
  void need(const std::string& requirement) const {
    if (domain_.requirements.count(requirement) == 0) fail("used without " + requirement);
  }
  const PddlDomain& domain_;
  std::map<std::string, std::string> scope_;
};

}  // namespace

std::vector<PddlVariable> pddl_variables(const PddlList& list, std::size_t from, bool variables) {
  std::vector<PddlVariable> found;
  std::size_t untyped = 0;
  std::set<std::string> names;
  for (std::size_t i = from; i < list.parts.size(); ++i) {
    const auto& word = list.parts[i].word;
    if (word == "-") {
      if (++i >= list.parts.size()) fail("a type is missing");
      for (; untyped < found.size(); ++untyped) found[untyped].type = name_of(list.parts[i]);
      continue;
    }
    const bool sound = variables ? word.size() > 1 && word[0] == '?' && is_name(word.substr(1)) : is_name(word);
    if (!sound) fail("'" + word + "' is no " + (variables ? "variable" : "name"));
    if (!names.insert(word).second) fail(word + " occurs twice");
    found.push_back({word, "object"});
  }
  return found;
}

PddlDomain read_pddl_domain(std::string_view text) {
  static const std::set<std::string> kKnown{":strips",
                                            ":typing",
                                            ":equality",
                                            ":negative-preconditions",
                                            ":disjunctive-preconditions",
                                            ":conditional-effects",
                                            ":universal-preconditions"};
  const auto whole = Reader(text).whole();
  PddlDomain domain;
  if (!is_headed(whole, "define") || whole.parts.size() < 2 || !is_headed(whole.parts[1], "domain"))
    fail("(define (domain …) was expected");
  domain.name = name_of(whole.parts[1].parts.at(1));
  domain.types["object"] = "";
  for (std::size_t i = 2; i < whole.parts.size(); ++i) {
    const auto& section = whole.parts[i];
    if (is_headed(section, ":requirements")) {
      for (std::size_t k = 1; k < section.parts.size(); ++k) {
        if (kKnown.count(section.parts[k].word) == 0) fail("unknown requirement " + section.parts[k].word);
        domain.requirements.insert(section.parts[k].word);
      }
    } else if (is_headed(section, ":types")) {
      for (const auto& type : pddl_variables(section, 1, false)) domain.types[type.name] = type.type;
    } else if (is_headed(section, ":predicates")) {
      for (std::size_t k = 1; k < section.parts.size(); ++k) {
        const auto variables = pddl_variables(section.parts[k], 1, true);
        Checker(domain, {}).declare(variables);
        if (!domain.predicates.emplace(name_of(section.parts[k].parts.at(0)), variables).second)
          fail("predicate " + section.parts[k].parts[0].word + " occurs twice");
      }
    } else if (is_headed(section, ":action")) {
      if (section.parts.size() != 8 || section.parts[2].word != ":parameters" ||
          section.parts[4].word != ":precondition" || section.parts[6].word != ":effect")
        fail("an action has parameters, precondition and effect");
      PddlAction action{pddl_variables(section.parts[3], 0, true), section.parts[5], section.parts[7]};
      Checker checker(domain, {});
      checker.declare(action.parameters);
      checker.condition(action.precondition);
      checker.effect(action.effect);
      if (!domain.actions.emplace(name_of(section.parts[1]), std::move(action)).second)
        fail("action " + section.parts[1].word + " occurs twice");
    } else {
      fail("unknown section");
    }
  }
  return domain;
}

PddlProblem read_pddl_problem(std::string_view text, const PddlDomain& domain) {
  const auto whole = Reader(text).whole();
  if (whole.parts.size() != 6 || !is_headed(whole.parts[1], "problem") || !is_headed(whole.parts[2], ":domain") ||
      !is_headed(whole.parts[3], ":objects") || !is_headed(whole.parts[4], ":init") ||
      !is_headed(whole.parts[5], ":goal"))
    fail("a problem has a domain, objects, init and a goal");
  PddlProblem problem;
  problem.name = name_of(whole.parts[1].parts.at(1));
  if (whole.parts[2].parts.at(1).word != domain.name) fail("a problem of another domain");
  for (const auto& object : pddl_variables(whole.parts[3], 1, false)) {
    if (domain.types.count(object.type) == 0) fail("unknown type " + object.type);
    problem.objects[object.name] = object.type;
  }
  Checker checker(domain, problem.objects);
  for (std::size_t i = 1; i < whole.parts[4].parts.size(); ++i) {
    const auto& fact = whole.parts[4].parts[i];
    checker.atom(fact);
    PddlFact words;
    for (const auto& part : fact.parts) words.push_back(part.word);
    if (!problem.init.insert(words).second) fail("a fact occurs twice: " + words[0]);
  }
  problem.goal = whole.parts[5].parts.at(1);
  checker.condition(problem.goal);
  return problem;
}

std::vector<PddlFact> read_pddl_plan(std::string_view text) {
  std::vector<PddlFact> plan;
  for (Reader reader(text); !reader.at_end();) {
    PddlFact step;
    for (const auto& part : reader.next().parts) step.push_back(name_of(part));
    plan.push_back(std::move(step));
  }
  return plan;
}

}  // namespace unietp::testing
