#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "pipeline/candidate.h"

namespace unietp {

/// Which attempt fills each slot, decided attempt by attempt and within one in slot order: the order of arrival never
/// matters.
class Selection {
 public:
  explicit Selection(std::size_t slots) : chosen_(slots, -1) {}

  std::vector<int> open_slots() const;
  /// Takes an accepted candidate unless it repeats a task already taken; says what it repeats.
  enum class Verdict { Taken, SameStart, SameText };
  Verdict offer(const CandidateRecord& record);

  /// Attempt that fills the slot, or -1.
  int chosen(int slot) const { return chosen_[static_cast<std::size_t>(slot)]; }
  int taken() const { return taken_; }

 private:
  std::vector<int> chosen_;
  std::set<std::string> start_keys_, text_keys_;
  int taken_ = 0;
};

}  // namespace unietp
