#pragma once

#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

namespace unietp {

/// Writes compact JSON directly into a string, value by value, without building a tree. Numbers are the shortest text
/// that reads back to the same bits, with a decimal point or an exponent; invalid UTF-8 becomes U+FFFD. Every object
/// and list that is opened must be closed.
class JsonText {
 public:
  explicit JsonText(std::string& text) : text_(text) {}

  /// What is opened becomes the next item of the list, or the value of the last key.
  void open_object() { open('{'); }
  void close_object() { close('}'); }
  void open_list() { open('['); }
  void close_list() { close(']'); }
  /// `name` is plain ASCII without quotes and backslashes.
  void key(std::string_view name);
  void value(std::string_view text);
  void value(const std::string& text) { value(std::string_view(text)); }
  void value(const char* text) {
    value(std::string_view(text));
  }                           // otherwise the compiler would choose the overload for bool
  void value(double number);  // one that is not finite becomes null, which no reader takes
  void value(bool truth);
  void value(int number);
  /// A whole JSON value, with numbers as above. Text written by this class, parsed and written again, does not change.
  void tree(const nlohmann::ordered_json& json);
  /// A value that is JSON text already.
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
  bool first_ = true;  // the innermost list or object has no item yet, or a key was just written
};

}  // namespace unietp
