// Says whether a mutant is switched on: the one whose number is in UNIETP_MUTANT. Where UNIETP_MUTANT_REACH names a
// file, the number of each mutant that a process comes by is appended to it, at once, so that it is kept whatever ends
// the process.
#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cstdlib>
#include <string>

bool unietp_mutant(int id);

namespace {

struct Switch {
  int on = 0;
  int reached_file = -1;
  std::array<std::atomic<bool>, 4096> reached{};

  Switch() {
    if (const char* chosen = std::getenv("UNIETP_MUTANT")) on = std::atoi(chosen);
    const char* path = std::getenv("UNIETP_MUTANT_REACH");
    if (path == nullptr) return;
    // Not one of the first numbers: where a test starts a program without standard output, its text would go to the
    // file.
    const int file = ::open(path, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
    reached_file = ::fcntl(file, F_DUPFD_CLOEXEC, 100);
    ::close(file);
  }

  void record(int id) {
    if (reached.at(static_cast<std::size_t>(id)).exchange(true)) return;
    const auto line = std::to_string(id) + "\n";
    if (::write(reached_file, line.data(), line.size()) < 0) std::abort();
  }
};

}  // namespace

bool unietp_mutant(int id) {
  static Switch the_switch;
  if (the_switch.reached_file >= 0) the_switch.record(id);
  return id == the_switch.on;
}
