#include "bodies.h"
#include "evaluation/episode_log.h"
#include "evaluation/evaluation_manifest.h"
#include "evaluation/program_policy.h"
#include "evaluation/prompt_slots.h"
#include "evaluation/simulator_program.h"
#include "fuzz_bodies.h"
#include "llm/chat_reply.h"
#include "llm/chat_request.h"
#include "scores/episode_score.h"
#include "support.h"

namespace unietp::fuzz {
namespace {

/// What reads is written and read back the same.
template <class Record>
bool reads_back(Result<Record> (*read)(std::string_view, int, std::string_view), std::string (*write)(const Record&),
                std::string_view text) {
  const auto record = read("log.jsonl", 1, text);
  if (!check_result(record)) return false;
  const auto again = read("log.jsonl", 1, write(*record));
  require(again && *again == *record);
  return true;
}

}  // namespace

bool episode_body(std::string_view text) {
  const bool episode = reads_back<EpisodeRecord>(&read_episode, &episode_line, text);
  const bool timing = reads_back<TimingRecord>(&read_timing, &timing_line, text);
  const bool reply = reads_back<LoggedReply>(&read_logged_reply, &reply_line, text);
  const bool score = reads_back<EpisodeScore>(&read_score, &score_line, text);
  const bool answer =
      check_result(read_policy_answer(text, 1)) || check_result(read_simulator_answer(text, 1, Scene(), Delta()));
  return episode || timing || reply || score || answer;
}

bool evaluation_body(std::string_view text) {
  const auto manifest = read_evaluation_manifest("manifest.json", text);
  if (!check_result(manifest)) return false;
  const auto again = read_evaluation_manifest("manifest.json", to_text(*manifest));
  require(again && *again == *manifest);
  return true;
}

bool prompt_body(std::string_view text) { return check_result(read_prompt("a.prompt", text, prompt_slot_names())); }

bool chat_body(std::string_view text) {
  constexpr std::string_view kKey = "sk-fuzz-0123";
  const bool extra = check_result(check_extra(std::string(text)));
  const bool stored = check_result(read_stored_reply(text));
  const auto reply = read_chat_reply(text, kKey);
  if (!check_result(reply)) return extra || stored;
  require(reply->text.find(kKey) == std::string::npos && reply->thinking.find(kKey) == std::string::npos);
  const auto again = read_stored_reply(to_text(*reply));
  require(again && *again == *reply);
  return true;
}

}  // namespace unietp::fuzz
