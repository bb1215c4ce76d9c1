#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <tuple>

#include "core/files.h"
#include "core/sexpr.h"
#include "core/text.h"
#include "sense/items.h"

namespace unietp {
namespace {

constexpr std::string_view kActivities = "metadata:activity_definitions", kOutside = "outside", kEnd = "problem0.bddl";
constexpr std::array<std::string_view, 4> kForms{"cooked__", "diced__", "half__", "melted__"};
constexpr std::array<std::pair<std::string_view, std::string_view>, 7> kStates{{{"cooked", "cook"},
                                                                                {"hot", "heat"},
                                                                                {"frozen", "freeze"},
                                                                                {"folded", "fold"},
                                                                                {"broken", "break"},
                                                                                {"unfolded", "unfold"},
                                                                                {"toggled_on", "switch_on"}}};

/// "?rag.n.01_2" and "rag.n.01_2" -> "rag.n.01".
std::string synset_of(std::string_view term) {
  if (term.starts_with('?')) term.remove_prefix(1);
  const auto mark = term.rfind('_');
  const auto dot = term.rfind('.');
  return std::string(
      mark != std::string_view::npos && dot != std::string_view::npos && mark > dot ? term.substr(0, mark) : term);
}

std::string lemma_of(const std::string& synset) { return synset.substr(0, synset.rfind(".n.")); }

std::optional<std::string> kind_of(std::string synset, const Vocabulary& vocabulary) {
  for (bool again = true; again;) {
    again = false;
    for (const auto form : kForms) {
      if (!synset.starts_with(form)) continue;
      synset = synset.substr(form.size());
      again = true;
    }
  }
  const auto found =
      std::lower_bound(vocabulary.synsets.begin(), vocabulary.synsets.end(), std::pair(synset, std::string()));
  if (found != vocabulary.synsets.end() && found->first == synset) {
    if (auto kind = vocabulary.words.of_word(found->second)) return kind;
  }
  if (auto kind = vocabulary.words.of_word(replace_all(lemma_of(synset), "__", "_"))) return kind;
  if (const auto fact = vocabulary.words.of_synset(synset, vocabulary.net)) return fact->kind;
  return std::nullopt;
}

/// What one goal says: kind, role and words of each literal.
class GoalReader {
 public:
  explicit GoalReader(const Vocabulary& vocabulary) : vocabulary_(vocabulary) {}

  void read(const Sexpr& part, bool negated) {
    if (!part.is_list() || part.children.empty()) return;
    const auto& head = part.children.front().text;
    const auto& children = part.children;
    if (head == "and" || head == "or") {
      for (std::size_t i = 1; i < children.size(); ++i) read(children[i], negated);
    } else if (head == "not" && children.size() > 1) {
      read(children[1], !negated);
    } else if (head == "imply" || head == "forall" || head == "exists") {
      if (children.size() > 2) read(children[2], negated);
    } else if (head == "forn" || head == "forpairs") {
      if (children.size() > 3) read(children[3], negated);
    } else if (head == "fornpairs") {
      if (children.size() > 4) read(children[4], negated);
    } else {
      literal(part, negated);
    }
  }

  std::set<std::tuple<std::string, Role, std::string>> found;  // kind, role, words

 private:
  void literal(const Sexpr& part, bool negated) {
    std::vector<std::string> terms;
    for (std::size_t i = 1; i < part.children.size(); ++i) terms.push_back(part.children[i].text);
    if (terms.empty()) return;
    const auto first = synset_of(terms.front());
    const auto thing = kind_of(first, vocabulary_);
    if (!thing || *thing == kOutside) return;
    const auto role = role_of(part.children.front().text, terms, negated);
    if (!role || role->ends_with(kOutside)) return;
    const auto words = (negated ? "not " : "") + part.children.front().text + " " + join(lemmas(terms), " ");
    keep(*thing, *role, terms.front(), words);
    for (const auto form : {"cooked__", "half__", "diced__"}) {
      for (const auto& term : terms) {
        const auto synset = synset_of(term);
        const auto kind = kind_of(synset, vocabulary_);
        if (synset.starts_with(form) && kind && *kind != kOutside)
          found.insert({*kind, std::string_view(form) == "cooked__" ? "cook" : "slice", lemma_of(synset)});
      }
    }
  }

  void keep(const std::string& thing, const Role& role, const std::string& term, const std::string& words) {
    found.insert({thing, role, words});
    const bool place = family_of(role) == "place";
    for (const auto& [other, its] : roles_) {  // a state, then a place, of one thing
      if (other != term || (family_of(its) == "place") == place) continue;
      found.insert({thing, place ? its + ">" + role : role + ">" + its, words});
    }
    roles_.emplace_back(term, role);
  }

  static std::vector<std::string> lemmas(const std::vector<std::string>& terms) {
    std::vector<std::string> all;
    for (const auto& term : terms) all.push_back(lemma_of(synset_of(term)));
    return all;
  }

  std::optional<Role> role_of(const std::string& head, const std::vector<std::string>& terms, bool negated) const {
    if (terms.size() == 1) {
      if (head == "open") return negated ? "close" : "open";
      if (head == "toggled_on" && negated) return "switch_off";
      if (head == "real" && !negated) {
        const auto synset = synset_of(terms.front());
        if (synset.starts_with("half__") || synset.starts_with("diced__")) return "slice";
      }
      for (const auto& [name, role] : kStates) {
        if (head == name && !negated) return std::string(role);
      }
      return std::nullopt;
    }
    const auto other = synset_of(terms[1]);
    return related(head, other, lemma_of(other), negated);
  }

  std::optional<Role> related(const std::string& head, const std::string& other, const std::string& lemma,
                              bool negated) const {
    const auto kind = kind_of(other, vocabulary_);
    if (head == "saturated" && lemma == "water") return negated ? "dry" : "soak";
    if (head == "covered" && negated) return lemma == "dust" ? "dust" : "wash";
    if (head == "covered" && kind) return "cover:" + *kind;
    if (head == "filled" || head == "contains") {
      if (negated) return "empty";
      if (lemma == "water") return "fill:water";
      if (lemma.find("coffee") != std::string::npos || lemma == "espresso" || lemma == "cappuccino")
        return "fill:coffee";
      if (lemma.find("wine") != std::string::npos && lemma.find("sauce") == std::string::npos) return "fill:wine";
      if (kind) return "fill:" + *kind;
      return std::nullopt;
    }
    if (negated || !kind) return std::nullopt;
    if (head == "ontop" || head == "draped" || head == "overlaid") return vocabulary_.kinds.place_role("on", *kind);
    if (head == "inside") return vocabulary_.kinds.place_role("in", *kind);
    if (head == "nextto") return "next_to:" + *kind;
    if (head == "under") return "under:" + *kind;
    if (head == "attached") return "attach:" + *kind;
    return std::nullopt;
  }

  const Vocabulary& vocabulary_;
  std::vector<std::pair<std::string, Role>> roles_;  // of the terms so far
};

/// Files of activities by name.
std::vector<std::pair<std::string, std::filesystem::path>> activities(const std::filesystem::path& folder) {
  std::vector<std::pair<std::string, std::filesystem::path>> all;
  std::error_code failed;
  for (const auto& entry : std::filesystem::directory_iterator(folder, failed)) {
    const auto name = entry.path().filename().string();
    if (std::filesystem::is_regular_file(entry.path() / kEnd)) {
      all.emplace_back(name, entry.path() / kEnd);
    } else if (name.ends_with("__" + std::string(kEnd))) {
      all.emplace_back(name.substr(0, name.size() - kEnd.size() - 2), entry.path());
    }
  }
  std::sort(all.begin(), all.end());
  return all;
}

}  // namespace

Result<std::vector<Item>> activity_items(const std::filesystem::path& folder, const Vocabulary& vocabulary) {
  const auto files = activities(folder);
  if (files.empty())
    return Error{
        Error::Kind::Io, folder.string(), {}, "expected activities: NAME/problem0.bddl or NAME__problem0.bddl"};
  std::vector<Item> items;
  for (const auto& [name, path] : files) {
    const auto text = read_file(path);
    if (!text) return text.error();
    const auto problem = read_sexpr(path.string(), *text);
    if (!problem) return problem.error();
    GoalReader goal(vocabulary);
    for (const auto& section : problem->children) {
      if (section.is_form(":goal") && section.children.size() > 1) goal.read(section.children[1], false);
    }
    for (const auto& [thing, role, words] : goal.found)
      items.push_back({{thing, role, 1, name + ": " + words, std::string(kActivities)}, name});
  }
  return items;
}

}  // namespace unietp
