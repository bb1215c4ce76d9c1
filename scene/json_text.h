#pragma once

#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

namespace unietp {

/// Appends compact JSON to a text, value by value: no tree is built. Numbers are the shortest that read back to the
/// same bits, with a decimal point or an exponent; broken UTF-8 becomes U+FFFD. What is opened has to be closed.
class JsonText {
 public:
  explicit JsonText(std::string& text) : text_(text) {}

  void open_object() { open('{'); }
  void close_object() { close('}'); }
  void open_list() { open('['); }
  void close_list() { close(']'); }
  /// `name` is plain ASCII without quotes and backslashes.
  void key(std::string_view name);
  void value(std::string_view text);
  void value(const std::string& text) { value(std::string_view(text)); }
  void value(const char* text) { value(std::string_view(text)); }  // without it a text would become a truth
  void value(double number);  // one that is not finite becomes null, which no reader takes
  void value(bool truth);
  void value(int number);
  /// A tree, its numbers as above: text of this class that was read and is written again stays as it was.
  void tree(const nlohmann::ordered_json& json);
  /// JSON that is written already.
  void raw(std::string_view json);

 private:
  void separate() {
    if (!first_) text_ += ',';
    first_ = false;
  }
  void open(char bracket) {
    separate();
    text_ += bracket;
    first_ = true;
  }
  void close(char bracket) {
    text_ += bracket;
    first_ = false;
  }
  std::string& text_;
  bool first_ = true;  // nothing stands before in the innermost list or object, or a key does
};

}  // namespace unietp
