#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>

namespace unietp {

/// Values by name, each made at its first use and kept. Thread-safe. Two threads may make the same value at once, so
/// what makes it must give equal values each time; the first one stays.
template <class T>
class LazyValues {
 public:
  /// The value of a name, made now if it is the first time.
  std::shared_ptr<const T> get(const std::string& name, const std::function<T()>& make) {
    {
      const std::scoped_lock lock(mutex_);
      if (const auto found = values_.find(name); found != values_.end()) return found->second;
    }
    auto made = std::make_shared<const T>(make());
    const std::scoped_lock lock(mutex_);
    return values_.emplace(name, std::move(made)).first->second;
  }

 private:
  std::mutex mutex_;
  std::map<std::string, std::shared_ptr<const T>> values_;
};

}  // namespace unietp
