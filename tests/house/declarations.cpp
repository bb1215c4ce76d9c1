#include "declarations.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <regex>

#include "core/text.h"

namespace unietp {
namespace {

/// A line without its comment and without what stands in quotes.
struct Line {
  std::string code;
  bool has_comment = false;
};

Line read_line(std::string_view text) {
  Line line;
  char quote = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quote != 0) {
      if (c == '\\') ++i;
      if (c == quote) quote = 0;
      if (quote == 0) line.code += c;
      continue;
    }
    if (text.substr(i, 2) == "//") {
      line.has_comment = true;
      break;
    }
    const bool separates_digits = c == '\'' && i > 0 && std::isdigit(static_cast<unsigned char>(text[i - 1])) != 0;
    if (c == '"' || (c == '\'' && !separates_digits)) quote = c;
    line.code += c;
  }
  line.code = std::string(trim(line.code));
  return line;
}

class HeaderReader {
 public:
  std::vector<Declaration> read(std::string_view header) {
    int number = 0;
    for (const auto& text : split(header, '\n')) {
      ++number;
      const Line line = read_line(text);
      if (line.code.starts_with('#')) continue;
      if (line.code.empty()) {
        if (!begun_) commented_ = line.has_comment;
        continue;
      }
      if (!begun_ && in_view()) begin(number);
      const bool in_body = !scopes_.empty() && scopes_.back() == Scope::Body;
      found_.commented = found_.commented || (line.has_comment && !in_body);
      for (const char c : line.code) take(c);
      if (begun_ && in_view() && !found_.text.empty()) found_.text += ' ';
    }
    return std::move(all_);
  }

 private:
  enum class Scope { Namespace, Public, Hidden, Body };

  bool in_view() const {
    return scopes_.empty() || scopes_.back() == Scope::Namespace || scopes_.back() == Scope::Public;
  }

  void begin(int line) {
    found_ = {line, "", !scopes_.empty() && scopes_.back() == Scope::Public, commented_};
    begun_ = true;
  }

  void take(char c) {
    if (c == '{') return open();
    if (c == '}') return close();
    if (scopes_.empty() || scopes_.back() != Scope::Body) {
      if (c == ';') return in_view() ? end() : forget();
      found_.text += c;
      if (c == ':') look_for_access();
    }
  }

  void open() {
    static const std::regex kNamespace("(inline )?namespace\\b.*"),
        kType("(template ?<.*> ?)?(class|struct|union)\\b[^(=]*");
    const std::string text(trim(found_.text));
    if (!in_view()) return scopes_.push_back(scopes_.back() == Scope::Hidden ? Scope::Body : scopes_.back());
    if (std::regex_match(text, kNamespace)) {
      scopes_.push_back(Scope::Namespace);
      forget();
    } else if (std::regex_match(std::regex_replace(text, std::regex("\\[\\[.*\\]\\]|alignas\\(.*?\\)"), ""), kType)) {
      const bool is_class = std::regex_search(text, std::regex("^(template ?<.*> ?)?class\\b"));
      found_.text = text + " {}";
      all_.push_back(found_);
      scopes_.push_back(is_class ? Scope::Hidden : Scope::Public);
      type_commented_.push_back(found_.commented);
      forget();
    } else {
      if (text.starts_with("enum")) found_.text = text + " {}";
      scopes_.push_back(Scope::Body);
    }
  }

  void close() {
    if (scopes_.empty()) return;
    const Scope closed = scopes_.back();
    scopes_.pop_back();
    if (closed == Scope::Body && !scopes_.empty() && scopes_.back() == Scope::Body) return;
    if (closed != Scope::Body || !in_view()) forget();
    if (closed == Scope::Public || closed == Scope::Hidden) {  // what follows without an empty line is of its group
      commented_ = type_commented_.back();
      type_commented_.pop_back();
    }
    if (closed != Scope::Body) return;
    static const std::regex kFunction(".*(\\)|const|noexcept|override) *");
    if (std::regex_match(found_.text, kFunction)) end();
  }

  void end() {
    found_.text = std::string(trim(found_.text));
    if (begun_ && !found_.text.empty()) {
      all_.push_back(found_);
      commented_ = found_.commented;
    }
    begun_ = false;
    found_ = {};
  }

  /// Begins anew behind a brace: no comment above counts for what follows.
  void forget() {
    begun_ = commented_ = false;
    found_ = {};
  }

  void look_for_access() {
    const auto text = trim(found_.text);
    if (text == "public:" || text == "private:" || text == "protected:") {
      scopes_.back() = text == "public:" ? Scope::Public : Scope::Hidden;
      forget();
    }
  }

  std::vector<Scope> scopes_;
  std::vector<Declaration> all_;
  std::vector<bool> type_commented_;  // of the types that are open
  Declaration found_;                 // the one that is being read
  bool begun_ = false;                // found_ has a line
  bool commented_ = false;            // a comment stands above the next declaration or its group
};

/// `List<Item<int>> all` as `List all`.
std::string without_arguments(std::string text) {
  static const std::regex kArguments(" ?<[^<>]*>");
  for (std::string last; last != text;) {
    last = text;
    text = std::regex_replace(text, kArguments, "");
  }
  return text;
}

}  // namespace

std::vector<Declaration> public_declarations(std::string_view header) { return HeaderReader().read(header); }

bool needs_comment(const Declaration& declaration) {
  static const std::regex kForward("(enum )?(class|struct) [\\w:]+( : [\\w:]+)?"),
      kConstructor(
          "template (explicit |virtual |constexpr )*~?(\\w+)\\(.*|(explicit |virtual |constexpr )*~?(\\w+)\\(.*"),
      kUsual(".*\\b(size|empty|begin|end)\\(\\) const( noexcept)?");
  const std::string& text = declaration.text;
  static const std::array kNever{"operator", "= default", "= delete", " override", "friend ", "static_assert"};
  if (std::any_of(kNever.begin(), kNever.end(), [&](const char* word) { return text.find(word) != std::string::npos; }))
    return false;
  if (std::regex_match(text, kForward)) return false;
  if (text.ends_with("{}")) return !declaration.is_member;
  const std::string plain = without_arguments(text);
  const auto call = plain.find('(');
  if (!declaration.is_member) {
    static const std::regex kDefinedOutside(".*\\w::\\w+$");
    return call == std::string::npos || !std::regex_match(plain.substr(0, call), kDefinedOutside);
  }
  const bool is_data = call == std::string::npos || plain.find('=') < call || plain.find("(*") == call;
  return !is_data && !std::regex_match(plain, kConstructor) && !std::regex_match(text, kUsual);
}

}  // namespace unietp
