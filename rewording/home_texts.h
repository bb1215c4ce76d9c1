#pragma once

#include <map>
#include <set>
#include <string>

namespace unietp {

/// The texts of a data set by home, which tell whether a text is new in its home. Texts that differ in case, spaces or
/// punctuation only are equal (normalized_text). What is known of a home is forgotten after its last task.
class HomeTexts {
 public:
  /// One more task of the home will be passed. Homes of which none is expected are never forgotten.
  void expect(const std::string& layout) { ++homes_[layout].tasks_left; }
  /// False: the home has this text already.
  bool add(const std::string& layout, const std::string& text);
  bool contains(const std::string& layout, const std::string& text) const;
  /// A task of the home was passed.
  void pass(const std::string& layout);

 private:
  struct Home {
    int tasks_left = 0;
    std::set<std::string> texts;
  };
  std::map<std::string, Home> homes_;
};

}  // namespace unietp
