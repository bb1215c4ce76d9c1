#pragma once

#include <memory>
#include <string>
#include <vector>

#include "annotator/noun_table.h"
#include "core/result.h"

namespace unietp {

/// The English dictionaries of Hunspell, American and British. Opening them takes some tenths of a second, lookups are
/// fast. Not thread-safe.
class Spelling {
 public:
  /// Errors: Io when a dictionary is not installed, with the packages that hold them.
  static Result<Spelling> open();
  Spelling(Spelling&&) noexcept;
  Spelling& operator=(Spelling&&) noexcept;
  ~Spelling();

  /// Words of a text that are neither in a dictionary nor in the lexicon of nouns, each once, with a suggestion:
  /// "the word 'micorwave' is in no dictionary (microwave?)". Numbers and punctuation are left out.
  std::vector<std::string> faults(const std::string& text, const NounTable& nouns) const;

 private:
  struct Dictionaries;
  explicit Spelling(std::unique_ptr<Dictionaries> dictionaries);
  std::unique_ptr<Dictionaries> dictionaries_;
};

}  // namespace unietp
