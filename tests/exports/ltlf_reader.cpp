#include "ltlf_reader.h"

#include <cctype>
#include <stdexcept>

namespace unietp::testing {
namespace {

struct Node {
  char op = 'p';  // '!', '&', '|', 'F', 'G', 'U', or 'p' for a name
  std::string name;
  std::vector<Node> children;
};

class Reader {
 public:
  explicit Reader(const std::string& text) : text_(text) {}
  Node whole() {
    Node node = binary();
    if (peek() != '\0') throw std::runtime_error("more after the formula: " + text_.substr(at_));
    return node;
  }

 private:
  char peek() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
    return at_ < text_.size() ? text_[at_] : '\0';
  }
  Node binary() {
    Node node = unary();
    const char first = peek();
    for (char op = first; op == '&' || op == '|' || op == 'U'; op = peek()) {
      if (op != first) throw std::runtime_error("operators are mixed without parentheses");
      ++at_;
      Node right = unary();
      node = {op, "", {std::move(node), std::move(right)}};
    }
    return node;
  }
  Node unary() {
    const char c = peek();
    if (c == '!' || c == 'F' || c == 'G') {
      ++at_;
      return {c, "", {unary()}};
    }
    if (c == '(') {
      ++at_;
      Node node = binary();
      if (peek() != ')') throw std::runtime_error("expected ) at " + text_.substr(at_));
      ++at_;
      return node;
    }
    Node node;
    for (; at_ < text_.size() && (std::islower(text_[at_]) || std::isdigit(text_[at_]) || text_[at_] == '_'); ++at_)
      node.name += text_[at_];
    if (node.name.empty()) throw std::runtime_error("expected a name at " + text_.substr(at_));
    return node;
  }

  const std::string& text_;
  std::size_t at_ = 0;
};

bool holds(const Node& node, const LtlfTrace& trace, std::size_t i) {
  const auto child = [&](std::size_t k, std::size_t at) { return holds(node.children[k], trace, at); };
  switch (node.op) {
    case '!':
      return !child(0, i);
    case '&':
      return child(0, i) && child(1, i);
    case '|':
      return child(0, i) || child(1, i);
    case 'F':
      for (std::size_t j = i; j < trace.size(); ++j) {
        if (child(0, j)) return true;
      }
      return false;
    case 'G':
      for (std::size_t j = i; j < trace.size(); ++j) {
        if (!child(0, j)) return false;
      }
      return true;
    case 'U':
      for (std::size_t j = i; j < trace.size(); ++j) {
        if (child(1, j)) return true;
        if (!child(0, j)) return false;
      }
      return false;
    default:
      return node.name == "true" || (node.name != "false" && trace[i].contains(node.name));
  }
}

}  // namespace

bool ltlf_holds(const std::string& formula, const LtlfTrace& trace) { return holds(Reader(formula).whole(), trace, 0); }

}  // namespace unietp::testing
