#pragma once

#include <filesystem>

#include <gtest/gtest.h>

#include "sense/common_sense.h"
#include "sense/word_kinds.h"

namespace unietp::test {

inline std::filesystem::path sense_tables() { return std::filesystem::path(UNIETP_SOURCE_DIR) / "data/sense"; }

/// The committed tables, read once a process.
inline const CommonSense& committed_sense() {
  static const CommonSense sense = [] {
    std::vector<Error> errors;
    auto read = read_common_sense(sense_tables(), errors);
    for (const auto& error : errors) ADD_FAILURE() << format(error);
    return read;
  }();
  return sense;
}

inline const WordKinds& committed_words() {
  static const WordKinds words = [] {
    std::vector<Error> errors;
    auto read = read_word_kinds(sense_tables(), committed_sense().kinds(), errors);
    for (const auto& error : errors) ADD_FAILURE() << format(error);
    return read;
  }();
  return words;
}

}  // namespace unietp::test
