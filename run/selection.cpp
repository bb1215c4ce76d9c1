#include "run/selection.h"

namespace unietp {

std::vector<int> Selection::open_slots() const {
  std::vector<int> open;
  for (std::size_t i = 0; i < chosen_.size(); ++i) {
    if (chosen_[i] < 0) open.push_back(first_ + static_cast<int>(i));
  }
  return open;
}

Selection::Verdict Selection::offer(const CandidateRecord& record) {
  const auto verdict = start_keys_.contains(record.start_key) ? Verdict::SameStart
                       : text_keys_.contains(record.text_key) ? Verdict::SameText
                                                              : Verdict::Taken;
  if (verdict != Verdict::Taken) {
    repeats_[at(record.slot)].emplace_back(record.attempt, verdict);
    return verdict;
  }
  start_keys_.insert(record.start_key);
  text_keys_.insert(record.text_key);
  chosen_[at(record.slot)] = record.attempt;
  ++taken_;
  return verdict;
}

void Selection::offer_all(const std::vector<CandidateRecord>& outlines) {
  for (const auto& record : outlines) {
    if (record.accepted && chosen(record.slot) < 0) (void)offer(record);
  }
}

Selection::Verdict Selection::verdict(int slot, int attempt) const {
  for (const auto& [repeated, verdict] : repeats_[at(slot)]) {
    if (repeated == attempt) return verdict;
  }
  return Verdict::Taken;
}

}  // namespace unietp
