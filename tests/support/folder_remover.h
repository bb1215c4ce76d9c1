#pragma once

#include <atomic>
#include <filesystem>
#include <thread>
#include <vector>

namespace unietp {

/// Another process that removes folders that it made, while a test makes them. Each sweep comes in between at most as
/// often as there are folders, so that a test knows how many tries are enough.
class FolderRemover {
 public:
  /// The deepest folder first.
  explicit FolderRemover(std::vector<std::filesystem::path> folders)
      : folders_(std::move(folders)), thread_([this](const std::stop_token& stop) { run(stop); }) {}

  /// Begins to sweep this often, when the sweeps before have ended.
  void sweep(int times) {
    while (left_ != 0) std::this_thread::yield();
    left_ = times;
  }

 private:
  void run(const std::stop_token& stop) {
    std::error_code code;
    while (!stop.stop_requested()) {
      if (left_ == 0) {
        std::this_thread::yield();
        continue;
      }
      for (const auto& folder : folders_) std::filesystem::remove(folder, code);
      --left_;
    }
  }

  std::vector<std::filesystem::path> folders_;
  std::atomic<int> left_{0};
  std::jthread thread_;
};

}  // namespace unietp
