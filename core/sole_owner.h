#pragma once

#include <atomic>
#include <memory>

namespace unietp {

/// Whether `owner` is the only owner of its value and may change it. What former owners in other threads did with the
/// value has then finished.
template <class T>
bool is_sole_owner(const std::shared_ptr<T>& owner) {
  if (owner.use_count() != 1) return false;
#ifdef __SANITIZE_THREAD__
  std::shared_ptr<T>{owner}.reset();  // ThreadSanitizer knows no fences; dropping a copy synchronizes as well
#else
  std::atomic_thread_fence(std::memory_order_acquire);
#endif
  return true;
}

}  // namespace unietp
