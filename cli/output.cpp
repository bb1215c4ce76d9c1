#include "cli/output.h"

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace unietp {
namespace {

constexpr const char* kName = "standard output";

/// The lowest descriptor that is free is the one that is closed.
void open_nothing(int descriptor, int access) {
  if (::fcntl(descriptor, F_GETFD) < 0) (void)::open("/dev/null", access);
}

}  // namespace

Result<Done> prepare_output() {
  (void)::signal(SIGPIPE, SIG_IGN);
  (void)::signal(SIGXFSZ, SIG_IGN);
  open_nothing(STDIN_FILENO, O_RDONLY);
  const bool closed = ::fcntl(STDOUT_FILENO, F_GETFD) < 0;
  if (closed) (void)::open("/dev/null", O_WRONLY);
  open_nothing(STDERR_FILENO, O_WRONLY);
  if (closed) return Error{Error::Kind::Usage, kName, {}, "is closed; send it to a file, a pipe or /dev/null"};
  return Done{};
}

Result<Done> finish_output() {
  errno = 0;
  const bool flushed = std::fflush(stdout) == 0;
  const int reason = errno;
  if (flushed && std::ferror(stdout) == 0) return Done{};
  return Error{Error::Kind::Io,
               kName,
               {},
               std::string("cannot write: ") + (reason != 0 ? std::strerror(reason) : "an earlier part was refused")};
}

}  // namespace unietp
