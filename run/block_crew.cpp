#include "run/block_crew.h"

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <map>
#include <memory>
#include <mutex>

#include "core/share_work.h"

namespace unietp {
namespace {

class Crew {
 public:
  Crew(const RunConfiguration& configuration, const Resources& resources, const std::vector<Block>& blocks,
       Ledger& ledger, const CrewOrders& orders)
      : configuration_(configuration), resources_(resources), blocks_(blocks), ledger_(ledger), orders_(orders) {}

  Result<bool> work() {
    run_on_threads(orders_.threads, [this] { take_part(); });
    if (thrown_) std::rethrow_exception(thrown_);
    if (failure_) return *failure_;
    return is_done();
  }

 private:
  /// A block under way and how much of its batch is given out and still to be done.
  struct Active {
    std::size_t block = 0;
    std::unique_ptr<BlockRun> run;
    std::size_t pieces = 0, given = 0, left = 0;
  };
  using Lock = std::unique_lock<std::mutex>;

  bool is_done() const { return handed_on_ == blocks_.size(); }
  bool is_over() const { return thrown_ || failure_ || is_done() || (orders_.stop != nullptr && orders_.stop->load()); }

  void take_part() {
    Lock lock(mutex_);
    while (!is_over()) {
      if (!hand_on(lock) && !do_piece(lock) && !begin_block(lock)) changed_.wait(lock);
    }
    changed_.notify_all();
  }

  /// Without the lock; a broken invariant is carried to the caller's thread.
  template <class Work>
  void outside(Lock& lock, const Work& work) {
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

  /// The next block in order, when it is done.
  bool hand_on(Lock& lock) {
    const auto next = finished_.find(handed_on_);
    if (handing_on_ || next == finished_.end()) return false;
    handing_on_ = true;
    auto run = std::move(next->second);
    finished_.erase(next);
    std::optional<Error> error;
    outside(lock, [&] {
      if (auto done = orders_.done(blocks_[handed_on_], *run); !done) error = done.error();
      run.reset();
    });
    if (error) failure_ = error;
    handing_on_ = false;
    ++handed_on_;
    return true;
  }

  bool do_piece(Lock& lock) {
    const auto found =
        std::find_if(active_.begin(), active_.end(), [](const auto& one) { return one->given < one->pieces; });
    if (found == active_.end()) return false;
    Active& active = **found;
    const std::size_t piece = active.given++;
    outside(lock, [&] { active.run->work(piece); });
    if (--active.left == 0 && !is_over()) advance(active, lock);
    return true;
  }

  bool begin_block(Lock& lock) {
    const std::size_t most = 2 + static_cast<std::size_t>(orders_.threads) / 8;  // their homes are in memory
    if (begun_ == blocks_.size() || active_.size() >= most) return false;
    Active& active = *active_.emplace_back(std::make_unique<Active>());
    active.block = begun_++;
    outside(lock, [&] {
      active.run = std::make_unique<BlockRun>(configuration_, resources_, blocks_[active.block], ledger_, orders_.news);
    });
    if (!is_over()) advance(active, lock);
    return true;
  }

  /// The block's next batch is given out, or it is done.
  void advance(Active& active, Lock& lock) {
    std::optional<Error> error;
    std::size_t pieces = 0;
    outside(lock, [&] {
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
  const CrewOrders& orders_;

  std::mutex mutex_;  // guards all below
  std::condition_variable changed_;
  std::vector<std::unique_ptr<Active>> active_;                // in the order of the blocks
  std::map<std::size_t, std::unique_ptr<BlockRun>> finished_;  // not handed on yet
  std::size_t begun_ = 0, handed_on_ = 0;
  bool handing_on_ = false;
  std::optional<Error> failure_;
  std::exception_ptr thrown_;
};

}  // namespace

Result<bool> fill_blocks(const RunConfiguration& configuration, const Resources& resources,
                         const std::vector<Block>& blocks, Ledger& ledger, const CrewOrders& orders) {
  return Crew(configuration, resources, blocks, ledger, orders).work();
}

}  // namespace unietp
