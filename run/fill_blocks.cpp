#include "run/fill_blocks.h"

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <map>
#include <memory>
#include <mutex>

#include "core/share_work.h"

namespace unietp {
namespace {

/// Threads that share the blocks of a run.
class BlockWorkers {
 public:
  BlockWorkers(const RunConfiguration& configuration, const Resources& resources, const std::vector<Block>& blocks,
               Ledger& ledger, const FillOptions& options)
      : configuration_(configuration), resources_(resources), blocks_(blocks), ledger_(ledger), options_(options) {}

  /// True when all blocks are filled, false when stopped from outside.
  Result<bool> run() {
    run_on_threads(options_.threads, [this] { work_loop(); });
    if (thrown_) std::rethrow_exception(thrown_);
    if (failure_) return *failure_;
    return is_done();
  }

 private:
  /// A block that is being filled, and how many pieces of its batch were handed out and are not finished.
  struct Active {
    std::size_t block = 0;
    std::unique_ptr<BlockRun> run;
    std::size_t pieces = 0, given = 0, left = 0;
  };
  using Lock = std::unique_lock<std::mutex>;

  bool is_done() const { return reported_ == blocks_.size(); }
  bool is_over() const {
    return thrown_ || failure_ || is_done() || (options_.stop != nullptr && options_.stop->load());
  }

  void work_loop() {
    Lock lock(mutex_);
    while (!is_over()) {
      if (!report_block(lock) && !do_piece(lock) && !start_block(lock)) changed_.wait(lock);
    }
    changed_.notify_all();
  }

  /// Runs work without the lock; an exception is rethrown in the thread that called `work`.
  template <class Work>
  void unlocked(Lock& lock, const Work& work) {
    lock.unlock();
    std::exception_ptr thrown;
    try {
      work();
    } catch (...) {
      thrown = std::current_exception();
    }
    lock.lock();
    if (thrown) thrown_ = thrown;
    changed_.notify_all();
  }

  /// Reports the next block in order if it is finished; false when there is none.
  bool report_block(Lock& lock) {
    const auto next = finished_.find(reported_);
    if (reporting_ || next == finished_.end()) return false;
    reporting_ = true;
    auto run = std::move(next->second);
    finished_.erase(next);
    std::optional<Error> error;
    unlocked(lock, [&] {
      if (auto done = options_.on_block(blocks_[reported_], *run); !done) error = done.error();
      run.reset();
    });
    if (error) failure_ = error;
    reporting_ = false;
    ++reported_;
    return true;
  }

  bool do_piece(Lock& lock) {
    const auto found =
        std::find_if(active_.begin(), active_.end(), [](const auto& one) { return one->given < one->pieces; });
    if (found == active_.end()) return false;
    Active& active = **found;
    const std::size_t piece = active.given++;
    unlocked(lock, [&] { active.run->work(piece); });
    if (--active.left == 0 && !is_over()) advance(active, lock);
    return true;
  }

  bool start_block(Lock& lock) {
    const std::size_t most = 2 + static_cast<std::size_t>(options_.threads) / 8;  // their homes are in memory
    if (started_ == blocks_.size() || active_.size() >= most) return false;
    Active& active = *active_.emplace_back(std::make_unique<Active>());
    active.block = started_++;
    unlocked(lock, [&] {
      active.run =
          std::make_unique<BlockRun>(configuration_, resources_, blocks_[active.block], ledger_, options_.callbacks);
    });
    if (!is_over()) advance(active, lock);
    return true;
  }

  /// Makes the block's next batch available, or marks the block as finished.
  void advance(Active& active, Lock& lock) {
    std::optional<Error> error;
    std::size_t pieces = 0;
    unlocked(lock, [&] {
      if (const auto batch = active.run->next_batch()) {
        pieces = *batch;
      } else {
        error = batch.error();
      }
    });
    if (error) failure_ = error;
    if (is_over()) return;
    active.given = 0;
    active.pieces = active.left = pieces;
    if (pieces > 0) return;
    finished_.emplace(active.block, std::move(active.run));
    std::erase_if(active_, [&](const auto& one) { return one.get() == &active; });
  }

  const RunConfiguration& configuration_;
  const Resources& resources_;
  const std::vector<Block>& blocks_;
  Ledger& ledger_;
  const FillOptions& options_;

  std::mutex mutex_;  // guards all below
  std::condition_variable changed_;
  std::vector<std::unique_ptr<Active>> active_;                // in the order of the blocks
  std::map<std::size_t, std::unique_ptr<BlockRun>> finished_;  // not reported yet
  std::size_t started_ = 0, reported_ = 0;
  bool reporting_ = false;
  std::optional<Error> failure_;
  std::exception_ptr thrown_;
};

}  // namespace

Result<bool> fill_blocks(const RunConfiguration& configuration, const Resources& resources,
                         const std::vector<Block>& blocks, Ledger& ledger, const FillOptions& options) {
  return BlockWorkers(configuration, resources, blocks, ledger, options).run();
}

}  // namespace unietp
