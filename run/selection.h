#pragma once

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "dataset/candidate.h"

namespace unietp {

/// Which attempt fills each slot of a block. Decided attempt by attempt, and within an attempt in slot order, so the
/// order in which candidates are finished does not matter.
class Selection {
 public:
  /// For the slots first, first + 1, …
  Selection(int first, std::size_t slots) : first_(first), chosen_(slots, -1), repeats_(slots) {}

  /// Slots without a task, ascending.
  std::vector<int> open_slots() const;
  /// Takes an accepted candidate for its open slot unless it repeats a task already taken; says what it repeats.
  enum class Verdict { Taken, SameStart, SameText };
  /// The slot of the record must be one of the block's.
  Verdict offer(const CandidateRecord& record);
  /// Offers all that were accepted, which come in order of attempt, then slot, to the slots that are still open.
  void offer_all(const std::vector<CandidateRecord>& outlines);

  /// Attempt that fills the slot, or -1.
  int chosen(int slot) const { return chosen_[at(slot)]; }
  /// What a rejected candidate repeated; Taken for any other.
  Verdict verdict(int slot, int attempt) const;
  /// Number of filled slots.
  int taken() const { return taken_; }

 private:
  std::size_t at(int slot) const { return static_cast<std::size_t>(slot - first_); }
  int first_;
  std::vector<int> chosen_;
  std::vector<std::vector<std::pair<int, Verdict>>> repeats_;  // by slot: attempt
  std::set<std::string> start_keys_, text_keys_;
  int taken_ = 0;
};

}  // namespace unietp
