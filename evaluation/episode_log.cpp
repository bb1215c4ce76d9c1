#include "evaluation/episode_log.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include <nlohmann/json.hpp>

#include "evaluation/episode_fields.h"
#include "record/line_file.h"
#include "record/record_fields.h"

namespace unietp {
namespace {

constexpr std::string_view kReplyStart = R"({"format":"unietp-reply/1")";
constexpr std::string_view kTimingStart = R"({"format":"unietp-timing/1")";

Error io_error(const std::filesystem::path& path, const std::string& what) {
  return {Error::Kind::Io, path.string(), {}, what + ": " + std::strerror(errno)};
}

}  // namespace

std::string reply_line(const LoggedReply& logged) {
  const PolicyReply& reply = logged.reply;
  nlohmann::ordered_json json{{"format", "unietp-reply/1"}};
  write_key(json, logged.key);
  json["step"] = logged.step;
  json["prompt"] = reply.prompt;
  json["reply"] = reply.text;
  json["thinking"] = reply.thinking;
  json["finish"] = reply.finish;
  json["model"] = reply.model;
  json["prompt_tokens"] = reply.prompt_tokens;
  json["completion_tokens"] = reply.completion_tokens;
  json["cost"] = reply.cost;
  json["attempts"] = reply.attempts;
  json["seconds"] = reply.seconds;
  return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

Result<LoggedReply> read_logged_reply(std::string_view where, int line, std::string_view text) {
  LoggedReply logged;
  PolicyReply& reply = logged.reply;
  const auto read = read_line(where, line, text, "unietp-reply/1", [&](JsonReader& reader, JsonFields& fields) {
    logged.key = read_key(reader, fields);
    if (const auto f = fields.required("step")) logged.step = read_whole(reader, *f);
    if (const auto f = fields.required("prompt")) reply.prompt = reader.line(*f);
    if (const auto f = fields.required("reply")) reply.text = text_or_empty(reader, *f);
    if (const auto f = fields.required("thinking")) reply.thinking = text_or_empty(reader, *f);
    if (const auto f = fields.required("finish")) reply.finish = text_or_empty(reader, *f);
    if (const auto f = fields.required("model")) reply.model = text_or_empty(reader, *f);
    if (const auto f = fields.required("prompt_tokens"))
      reply.prompt_tokens = static_cast<std::int64_t>(read_seed(reader, *f));
    if (const auto f = fields.required("completion_tokens"))
      reply.completion_tokens = static_cast<std::int64_t>(read_seed(reader, *f));
    if (const auto f = fields.required("cost")) reply.cost = read_not_negative(reader, *f);
    if (const auto f = fields.required("attempts")) reply.attempts = read_whole(reader, *f);
    if (const auto f = fields.required("seconds")) reply.seconds = read_not_negative(reader, *f);
  });
  if (!read) return read.error();
  return logged;
}

Result<EpisodeLog> EpisodeLog::open(const std::filesystem::path& folder) {
  const auto path = folder / kEpisodeLog;
  Descriptor file(::open(path.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC | O_NOFOLLOW, 0644));
  if (file.get() < 0) return io_error(path, "cannot be opened");
  EpisodeLog log(path, std::move(file));
  if (auto done = log.read(); !done) return done.error();
  return log;
}

Result<Done> EpisodeLog::read() {
  auto lines = LineFile::open(path_.parent_path(), kEpisodeLog, FileNames::WithFolder);
  if (!lines) return lines.error();
  const off_t size = ::lseek(file_.get(), 0, SEEK_END);
  std::uint64_t at = 0;
  std::size_t timing_bytes = 0;  // of a timing line just read, whose episode is to come
  std::uint64_t timing_at = 0;
  while (const auto line = lines->next()) {
    const std::size_t bytes = line->text.size() + 1;
    if (at + bytes > static_cast<std::uint64_t>(size)) break;  // cut by a kill
    if (!line->fault.empty()) return Error{Error::Kind::Schema, lines->at(line->number), {}, line->fault};
    if (line->text.starts_with(kReplyStart)) {
      const auto reply = read_logged_reply(lines->name(), line->number, line->text);
      if (!reply) return reply.error();
      take(*reply);
    } else if (line->text.starts_with(kTimingStart)) {
      const auto timing = read_timing(lines->name(), line->number, line->text);
      if (!timing) return timing.error();
      timing_bytes = bytes;
      timing_at = at;
    } else {
      const auto episode = read_episode(lines->name(), line->number, line->text);
      if (!episode) return episode.error();
      if (timing_bytes == 0)
        return Error{Error::Kind::Schema, lines->at(line->number), {}, "expected the line of its times before it"};
      take(*episode, timing_at, timing_bytes, bytes);
      timing_bytes = 0;
    }
    at += bytes;
  }
  // What a kill cut off: a part of a line, or the times of an episode whose line did not follow.
  const std::uint64_t sound = timing_bytes == 0 ? at : timing_at;
  if (sound < static_cast<std::uint64_t>(size) && ::ftruncate(file_.get(), static_cast<off_t>(sound)) != 0)
    return io_error(path_, "cannot be cut");
  state_->bytes = sound;
  return Done{};
}

void EpisodeLog::take(const LoggedReply& reply) {
  state_->cost += reply.reply.cost;
  state_->replies[reply.key].insert_or_assign({reply.step, reply.reply.prompt}, reply.reply);
}

void EpisodeLog::take(const EpisodeRecord& episode, std::uint64_t at, std::size_t timing_bytes,
                      std::size_t episode_bytes) {
  EndedEpisode ended;
  ended.errored = episode.end == EpisodeOutcome::Errored;
  ended.success = episode.success;
  ended.models = episode.models;
  for (const EpisodeStep& step : episode.steps) {
    ended.prompt_tokens += step.prompt_tokens;
    ended.completion_tokens += step.completion_tokens;
    ended.cost += step.cost;
  }
  ended.at = at;
  ended.timing_bytes = timing_bytes;
  ended.episode_bytes = episode_bytes;
  if (!ended.errored) state_->replies.erase(episode.key);
  state_->ended.insert_or_assign(episode.key, std::move(ended));
}

Result<Done> EpisodeLog::write(const std::string& lines) {
  std::size_t written = 0;
  while (written < lines.size()) {
    const ssize_t now = ::write(file_.get(), lines.data() + written, lines.size() - written);
    if (now < 0 && errno == EINTR) continue;
    if (now < 0) return io_error(path_, "cannot be written");
    written += static_cast<std::size_t>(now);
  }
  return Done{};
}

Result<Done> EpisodeLog::add(const LoggedReply& reply) {
  const std::string line = reply_line(reply) + "\n";
  const std::scoped_lock lock(state_->mutex);
  if (auto done = write(line); !done) return done;
  state_->bytes += line.size();
  take(reply);
  return Done{};
}

Result<Done> EpisodeLog::add(const EpisodeRecord& episode, const TimingRecord& timing) {
  const std::string first = timing_line(timing) + "\n", second = episode_line(episode) + "\n";
  const std::scoped_lock lock(state_->mutex);
  if (auto done = write(first + second); !done) return done;
  take(episode, state_->bytes, first.size(), second.size());
  state_->bytes += first.size() + second.size();
  return Done{};
}

std::optional<EndedEpisode> EpisodeLog::ended(const EpisodeKey& key) const {
  const std::scoped_lock lock(state_->mutex);
  const auto found = state_->ended.find(key);
  return found == state_->ended.end() ? std::nullopt : std::optional(found->second);
}

std::optional<PolicyReply> EpisodeLog::reply_to(const EpisodeKey& key, int step, const std::string& prompt) const {
  const std::scoped_lock lock(state_->mutex);
  const auto episode = state_->replies.find(key);
  if (episode == state_->replies.end()) return std::nullopt;
  const auto found = episode->second.find({step, prompt});
  return found == episode->second.end() ? std::nullopt : std::optional(found->second);
}

double EpisodeLog::cost() const {
  const std::scoped_lock lock(state_->mutex);
  return state_->cost;
}

Result<std::pair<std::string, std::string>> EpisodeLog::lines_of(const EndedEpisode& episode) const {
  std::string bytes(episode.timing_bytes + episode.episode_bytes, '\0');
  std::size_t read = 0;
  while (read < bytes.size()) {
    const ssize_t now =
        ::pread(file_.get(), bytes.data() + read, bytes.size() - read, static_cast<off_t>(episode.at + read));
    if (now < 0 && errno == EINTR) continue;
    if (now <= 0) return io_error(path_, "cannot be read");
    read += static_cast<std::size_t>(now);
  }
  return std::pair{bytes.substr(0, episode.timing_bytes), bytes.substr(episode.timing_bytes)};
}

}  // namespace unietp
