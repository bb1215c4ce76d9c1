#include "scores/watched_episodes.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

namespace unietp {
namespace {

Error io_error(const std::filesystem::path& folder, const std::string& what) {
  return {Error::Kind::Io, folder.string(), {}, what + ": " + std::strerror(errno)};
}

/// A file without a name. Where the file system has no such files, one that is removed at once.
Descriptor unnamed_file(const std::filesystem::path& folder) {
  const int number = ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
  if (number >= 0) return Descriptor(number);
  std::string name = (folder / "watched.XXXXXX").string();
  Descriptor file(::mkostemp(name.data(), O_CLOEXEC));
  if (file.get() >= 0) (void)::unlink(name.c_str());
  return file;
}

}  // namespace

class WatchedEpisodes::Watcher : public EpisodeWatcher {
 public:
  Watcher(std::shared_ptr<State> state, const JudgingData& data) : state_(std::move(state)), data_(data) {}

  void begin(const Environment& start) override {
    follower_.emplace(start);
    is_whole_ = true;
  }
  void before_reply(const Answer* answer, const Environment& now) override {
    if (!is_whole_) return;
    follower_->begin_reply(now);
    if (answer != nullptr) follower_->look(answer->actions.front(), now);
  }
  void after_reply(const std::string& unreadable, const StepResult& result, const Environment& now) override {
    is_whole_ = is_whole_ && result.executed.size() <= 1;
    if (!is_whole_) return;
    follower_->acted(result, now);
    follower_->end_reply(unreadable, now);
  }
  Result<Done> end(const EpisodeRecord& record, const Environment& last) override {
    if (!is_whole_) return Done{};
    const auto episode = judge_episode(record, std::move(*follower_).finish(last), *last.task(), data_, {});
    follower_.reset();
    const std::string score = score_line(episode.score.score);
    Place place{0, score.size(), episode.view.size(), episode.score.successful_actions};
    const std::string bytes = score + episode.view;
    const std::scoped_lock lock(state_->mutex);
    place.at = state_->bytes;
    for (std::size_t written = 0; written < bytes.size();) {
      const ssize_t now = ::pwrite(state_->file.get(), bytes.data() + written, bytes.size() - written,
                                   static_cast<off_t>(place.at + written));
      if (now < 0 && errno == EINTR) continue;
      if (now < 0) return io_error(state_->folder, "no episode can be kept here");
      written += static_cast<std::size_t>(now);
    }
    state_->bytes += bytes.size();
    state_->places.insert_or_assign(record.key, place);
    return Done{};
  }

 private:
  std::shared_ptr<State> state_;
  const JudgingData& data_;
  std::optional<EpisodeFollower> follower_;
  bool is_whole_ = true;
};

Result<WatchedEpisodes> WatchedEpisodes::begin(const std::filesystem::path& folder, const JudgingData& data) {
  auto state = std::make_shared<State>();
  state->folder = folder;
  state->file = unnamed_file(folder);
  if (state->file.get() < 0) return io_error(folder, "no file can be made here");
  return WatchedEpisodes(std::move(state), data);
}

WatcherMaker WatchedEpisodes::watchers() {
  return [state = state_, data = data_] { return std::make_unique<Watcher>(state, *data); };
}

Result<std::optional<JudgedEpisode>> WatchedEpisodes::find(const EpisodeKey& key) const {
  Place place;
  {
    const std::scoped_lock lock(state_->mutex);
    const auto found = state_->places.find(key);
    if (found == state_->places.end()) return std::optional<JudgedEpisode>();
    place = found->second;
  }
  std::string bytes(place.score_bytes + place.view_bytes, '\0');
  for (std::size_t read = 0; read < bytes.size();) {
    const ssize_t now =
        ::pread(state_->file.get(), bytes.data() + read, bytes.size() - read, static_cast<off_t>(place.at + read));
    if (now < 0 && errno == EINTR) continue;
    if (now <= 0) return io_error(state_->folder, "a kept episode cannot be read");
    read += static_cast<std::size_t>(now);
  }
  auto score = read_score("kept episode", 1, std::string_view(bytes).substr(0, place.score_bytes));
  if (!score) return score.error();
  return std::optional(JudgedEpisode{{std::move(*score), place.successful_actions}, bytes.substr(place.score_bytes)});
}

}  // namespace unietp
