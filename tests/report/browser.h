#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace unietp::test {

/// Headless Chromium in a process of its own, spoken to over its debugging pipe.
class Browser {
 public:
  using Json = nlohmann::json;

  static bool installed();
  /// Files that a page saves come to `folder`, where the profile lies, too.
  explicit Browser(const std::filesystem::path& folder);
  Browser(const Browser&) = delete;
  Browser& operator=(const Browser&) = delete;
  ~Browser();

  /// Opens a file and waits until the page says `data-ready`.
  void open(const std::filesystem::path& page);
  /// The same for an address.
  void visit(const std::string& url);
  /// The value of an expression; a promise is waited for.
  Json evaluate(const std::string& expression);
  /// Waits until the expression is true.
  void until(const std::string& expression);
  /// Presses a key: "a", "?", "ArrowRight", "Enter", "Escape".
  void press(const std::string& key, bool control = false);
  void type(const std::string& text);
  /// Waits for a file to be saved whole.
  std::string saved_file();

  /// Addresses that pages asked for, but for the pages themselves and what they hold (`data:`, `blob:`).
  std::vector<std::string> fetched;
  /// Errors of scripts and what the console complained of.
  std::vector<std::string> complaints;

 private:
  Json call(const std::string& method, Json parameters, bool of_page = true);
  Json read();  // the next message
  void note(const Json& event);

  std::filesystem::path folder_;
  pid_t process_ = -1;
  int to_ = -1, from_ = -1, last_ = 0;
  std::string session_, unread_, page_, saved_;
  bool is_saved_ = false;
};

}  // namespace unietp::test
