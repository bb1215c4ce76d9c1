#include "file_watch.h"

#include <poll.h>
#include <signal.h>
#include <sys/inotify.h>
#include <unistd.h>

#include <array>

namespace unietp {

FileWatch::FileWatch(const std::filesystem::path& folder) : watch_(::inotify_init1(IN_NONBLOCK | IN_CLOEXEC)) {
  add(folder);
}
FileWatch::~FileWatch() { ::close(watch_); }

int FileWatch::count() {
  pollfd ready{watch_, POLLIN, 0};
  (void)::poll(&ready, 1, 10);
  alignas(inotify_event) std::array<char, 4096> buffer{};
  for (ssize_t size = ::read(watch_, buffer.data(), buffer.size()); size > 0;
       size = ::read(watch_, buffer.data(), buffer.size())) {
    for (ssize_t at = 0; at < size;) {
      const auto* event = reinterpret_cast<const inotify_event*>(buffer.data() + at);
      ++count_;
      if ((event->mask & IN_ISDIR) != 0 && (event->mask & IN_CREATE) != 0) add(folders_[event->wd] / event->name);
      at += static_cast<ssize_t>(sizeof(inotify_event)) + event->len;
    }
  }
  return count_;
}

void FileWatch::add(const std::filesystem::path& folder) {
  constexpr std::uint32_t kChanges = IN_CREATE | IN_DELETE | IN_MODIFY | IN_MOVED_FROM | IN_MOVED_TO | IN_CLOSE_WRITE;
  const int id = ::inotify_add_watch(watch_, folder.c_str(), kChanges);
  if (id >= 0) folders_[id] = folder;
}

bool killed_after(RunningProgram& program, FileWatch& watch, int changes) {
  while (program.running()) {
    if (watch.count() < changes) continue;
    program.send(SIGKILL);
    return program.wait().signal == SIGKILL;
  }
  return false;
}

}  // namespace unietp
