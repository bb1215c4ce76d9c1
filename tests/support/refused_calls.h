#pragma once

#include <string>

namespace unietp {

/// While it lives, closing a file whose path ends in `ending` closes it and reports that its last bytes could not be
/// written (ENOSPC), as a network drive does. Only in test programs that use it, and in one thread.
class RefusedClose {
 public:
  explicit RefusedClose(std::string ending);
  RefusedClose(const RefusedClose&) = delete;
  RefusedClose& operator=(const RefusedClose&) = delete;
  ~RefusedClose();
};

/// While it lives, two folders cannot change places at once (EINVAL), as on a file system without that.
class RefusedExchange {
 public:
  RefusedExchange();
  RefusedExchange(const RefusedExchange&) = delete;
  RefusedExchange& operator=(const RefusedExchange&) = delete;
  ~RefusedExchange();
};

/// While it lives, no file of this process can grow beyond so many bytes (EFBIG), as on a full disk.
class RefusedGrowth {
 public:
  explicit RefusedGrowth(unsigned long bytes);
  RefusedGrowth(const RefusedGrowth&) = delete;
  RefusedGrowth& operator=(const RefusedGrowth&) = delete;
  ~RefusedGrowth();

 private:
  unsigned long before_ = 0;
};

}  // namespace unietp
