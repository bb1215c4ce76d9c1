#include "pipeline/selection.h"

namespace unietp {

std::vector<int> Selection::open_slots() const {
  std::vector<int> open;
  for (std::size_t i = 0; i < chosen_.size(); ++i) {
    if (chosen_[i] < 0) open.push_back(static_cast<int>(i));
  }
  return open;
}

Selection::Verdict Selection::offer(const CandidateRecord& record) {
  if (start_keys_.count(record.start_key) > 0) return Verdict::SameStart;
  if (text_keys_.count(record.text_key) > 0) return Verdict::SameText;
  start_keys_.insert(record.start_key);
  text_keys_.insert(record.text_key);
  chosen_[static_cast<std::size_t>(record.slot)] = record.attempt;
  ++taken_;
  return Verdict::Taken;
}

}  // namespace unietp
