#include "annotator/frames.h"

#include <array>
#include <cctype>
#include <string_view>

namespace unietp {
namespace {

/// What a command follows in the first sentence, and in later ones.
constexpr std::array<std::string_view, 20> kFirstFrames{"please ",           "could you ",
                                                        "could you please ", "can you ",
                                                        "can you please ",   "would you ",
                                                        "would you kindly ", "will you ",
                                                        "will you please ",  "kindly ",
                                                        "i need you to ",    "I'd like you to ",
                                                        "I want you to ",    "I would like you to ",
                                                        "you need to ",      "you should ",
                                                        "your task is to ",  "your job is to ",
                                                        "the task is to ",   "go ahead and "};
constexpr std::array<std::string_view, 12> kLaterFrames{
    "please ",          "could you ", "could you please ", "can you ", "would you ", "will you ", "i need you to ",
    "I'd like you to ", "also, ",     "also, please ",     "kindly ",  "you should "};

// Of 21,025 goals that people wrote for ALFRED, under one in a hundred has a courtesy.
constexpr double kPlease = 0.015, kQuestion = 0.01;

/// "could you do not" is wrong.
bool forbids(const std::string& command) {
  return command.starts_with("do not ") || command.starts_with("don't ") || command.find(" do not ") != command.npos ||
         command.find(" don't ") != command.npos;
}

template <class List>
std::string pick_from(const List& list, Rng& rng) {
  return std::string(list[rng.below(list.size())]);
}

}  // namespace

std::string sentence(std::string text, char end) {
  if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text + end;
}

std::string everyday_request(const std::string& command, bool is_first, Rng& rng) {
  const double drawn = rng.unit();
  if (!is_first || drawn > kPlease + kQuestion) return sentence(command, '.');
  const bool question = drawn > kPlease && !forbids(command);
  if (question) return sentence((rng.chance(0.5) ? "can you " : "could you ") + command, '?');
  return sentence("please " + command, '.');
}

std::vector<std::string> as_requests(const std::string& command) {
  std::vector<std::string> requests{sentence("please " + command, '.')};
  if (forbids(command)) return requests;
  for (const char* before : {"can you ", "could you ", "could you please "})
    requests.push_back(sentence(before + command, '?'));
  return requests;
}

std::string framed_request(const std::string& command, bool is_first, Rng& rng) {
  if (forbids(command)) return sentence((rng.chance(0.3) ? "please " : "") + command, '.');
  if (rng.chance(0.2)) return sentence(command, '.');
  const std::string before = is_first ? pick_from(kFirstFrames, rng) : pick_from(kLaterFrames, rng);
  if (before == "would you " && rng.chance(0.5)) return sentence(before + command + ", please", '?');
  const bool question = before.starts_with("could ") || before.starts_with("would ") || before.starts_with("can ") ||
                        before.starts_with("will ");
  return sentence(before + command, question ? '?' : '.');
}

}  // namespace unietp
