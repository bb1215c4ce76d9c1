#include "exports/ltlf_last_state.h"

#include <cctype>
#include <vector>

namespace unietp {
namespace {

constexpr const char* kHolds = "true";
constexpr const char* kFails = "false";

/// A formula as a tree: `sign` is one of ! & | F G U, or the name of a proposition, or true or false.
struct Tree {
  std::string sign;
  std::vector<Tree> parts;
};

/// Reads what ltlf_goal writes: parentheses around every operand.
class TreeReader {
 public:
  explicit TreeReader(const std::string& text) : text_(text) {}

  Tree read() {
    Tree first = operand();
    if (at_ >= text_.size() || text_[at_] != ' ') return first;
    Tree tree{std::string(1, text_[at_ + 1]), {std::move(first)}};
    while (at_ < text_.size() && text_[at_] == ' ') {
      at_ += 3;  // " & "
      tree.parts.push_back(operand());
    }
    return tree;
  }

 private:
  Tree operand() {
    Tree tree;
    while (at_ < text_.size() &&
           (std::isalnum(static_cast<unsigned char>(text_[at_])) != 0 || text_[at_] == '_' || text_[at_] == '!'))
      tree.sign += text_[at_++];
    if (at_ >= text_.size() || text_[at_] != '(') return tree;
    ++at_;
    Tree inner = read();
    ++at_;  // ")"
    if (tree.sign.empty()) return inner;
    tree.parts.push_back(std::move(inner));
    return tree;
  }

  const std::string& text_;
  std::size_t at_ = 0;
};

/// "(and a b)" without what says nothing.
std::string list(const std::string& word, const std::vector<std::string>& parts) {
  std::string neutral = word == "and" ? kHolds : kFails, absorbing = word == "and" ? kFails : kHolds;
  std::string text;
  std::size_t kept = 0;
  for (const std::string& part : parts) {
    if (part == absorbing) return absorbing;
    if (part == neutral) continue;
    text += " " + part;
    ++kept;
  }
  if (kept == 0) return neutral;
  return kept == 1 ? text.substr(1) : "(" + word + text + ")";
}

std::string negation(const std::string& text) {
  if (text == kHolds) return kFails;
  if (text == kFails) return kHolds;
  return "(not " + text + ")";
}

class LastStateWriter {
 public:
  LastStateWriter(const std::map<std::string, std::string>& literals, bool (*lasting)(const std::string&))
      : literals_(literals), lasting_(lasting) {}

  /// What the last state must meet if the formula holds (`must`), or from which it follows.
  std::string asked(const Tree& tree, bool must) {
    if (tree.sign == "&" || tree.sign == "|" || tree.sign == "!") {
      if (tree.sign == "!") return negation(asked(tree.parts[0], !must));
      return joined(tree, must);
    }
    if (tree.sign == kHolds || tree.sign == kFails) return tree.sign;
    if (tree.sign == "G" && tree.parts[0].sign == "F") return in_state(tree.parts[0].parts[0]);
    if (tree.sign == "F" && tree.parts[0].parts.empty() && lasting_(tree.parts[0].sign)) return in_state(tree.parts[0]);
    decides_ = false;
    if (tree.sign == "G" && must) return in_state(tree.parts[0]);
    if (tree.sign == "F" && !must) return in_state(tree.parts[0]);
    return must ? kHolds : kFails;
  }
  bool decides() const { return decides_; }

 private:
  std::string joined(const Tree& tree, bool must) {
    std::vector<std::string> parts;
    for (const Tree& part : tree.parts) parts.push_back(asked(part, must));
    return list(tree.sign == "&" ? "and" : "or", parts);
  }

  /// A formula read in the last state.
  std::string in_state(const Tree& tree) const {
    if (tree.sign == "!") return negation(in_state(tree.parts[0]));
    if (tree.sign == "&" || tree.sign == "|") {
      std::vector<std::string> parts;
      for (const Tree& part : tree.parts) parts.push_back(in_state(part));
      return list(tree.sign == "&" ? "and" : "or", parts);
    }
    if (!tree.parts.empty()) return in_state(tree.parts[0]);  // F or G of the last state is about that state
    const auto literal = literals_.find(tree.sign);
    return literal == literals_.end() ? tree.sign : literal->second;
  }

  const std::map<std::string, std::string>& literals_;
  bool (*lasting_)(const std::string&);
  bool decides_ = true;
};

}  // namespace

LastState last_state_of(const std::string& formula, const std::map<std::string, std::string>& literals,
                        bool (*lasting)(const std::string& proposition)) {
  LastStateWriter writer(literals, lasting);
  LastState made;
  made.text = writer.asked(TreeReader(formula).read(), true);
  made.decides = writer.decides();
  return made;
}

}  // namespace unietp
