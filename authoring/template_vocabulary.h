#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace unietp {

/// A word of the template language.
struct VocabularyWord {
  std::string word;     // "fits-on"
  std::string usage;    // "(fits-on A B [n])"
  std::string meaning;  // one line for people
};

/// A group of words, with subgroups.
struct VocabularyGroup {
  std::string name;   // "constraints", for programs
  std::string title;  // "Constraints", for people
  std::string says;   // where these words are used
  std::vector<VocabularyWord> words;
  std::vector<VocabularyGroup> groups;
};

/// Every word that a template may use, from the same tables as its reader.
std::vector<VocabularyGroup> template_vocabulary();

/// {"format": "unietp-vocabulary/1", "groups": [{name, title, says, words: [{word, usage, meaning}], groups: […]}]}
nlohmann::ordered_json vocabulary_json(const std::vector<VocabularyGroup>& groups);
/// docs/vocabulary.md
std::string vocabulary_page(const std::vector<VocabularyGroup>& groups);

}  // namespace unietp
