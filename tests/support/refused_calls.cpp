#include "tests/support/refused_calls.h"

#include <signal.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <string_view>

namespace unietp {
namespace {

// What the two functions below are to refuse. They take the place of the system's in the whole program, so there is no
// other way to tell them.
std::string refused_ending;
bool exchange_refused = false;

bool is_refused(int file) {
  if (refused_ending.empty()) return false;
  std::array<char, 4096> path{};
  const auto link = "/proc/self/fd/" + std::to_string(file);
  const auto size = ::readlink(link.c_str(), path.data(), path.size());
  return size > 0 && std::string_view(path.data(), static_cast<std::size_t>(size)).ends_with(refused_ending);
}

unsigned long set_growth(unsigned long bytes) {
  rlimit limit{};
  (void)::getrlimit(RLIMIT_FSIZE, &limit);
  const auto before = limit.rlim_cur;
  limit.rlim_cur = bytes;
  (void)::setrlimit(RLIMIT_FSIZE, &limit);
  return before;
}

}  // namespace

RefusedClose::RefusedClose(std::string ending) { refused_ending = std::move(ending); }
RefusedClose::~RefusedClose() { refused_ending.clear(); }

RefusedExchange::RefusedExchange() { exchange_refused = true; }
RefusedExchange::~RefusedExchange() { exchange_refused = false; }

RefusedGrowth::RefusedGrowth(unsigned long bytes) {
  (void)::signal(SIGXFSZ, SIG_IGN);
  before_ = set_growth(bytes);
}
RefusedGrowth::~RefusedGrowth() { (void)set_growth(before_); }

}  // namespace unietp

extern "C" {

int close(int file) {
  const bool refused = unietp::is_refused(file);
  const auto closed = static_cast<int>(::syscall(SYS_close, file));
  if (!refused || closed != 0) return closed;
  errno = ENOSPC;
  return -1;
}

int renameat2(int from_folder, const char* from, int to_folder, const char* to, unsigned int flags) noexcept {
  if (!unietp::exchange_refused)
    return static_cast<int>(::syscall(SYS_renameat2, from_folder, from, to_folder, to, flags));
  errno = EINVAL;
  return -1;
}
}
