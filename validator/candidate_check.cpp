#include "validator/candidate_check.h"

namespace unietp {

std::string task_id_of(const std::string& simulator, int slot) {
  constexpr std::size_t kDigits = 5;
  auto digits = std::to_string(slot + 1);
  digits.insert(0, digits.size() < kDigits ? kDigits - digits.size() : 0, '0');
  return simulator + "-" + digits;
}

int CandidateCheck::kind_of(const std::string& simulator, const std::string& split) {
  return kinds_.emplace(std::pair(simulator, split), static_cast<int>(kinds_.size())).first->second;
}

void CandidateCheck::add(const TaskRecord& task, const std::string& name, const std::string& where) {
  const auto wrong = [&](std::string message) {
    of_tasks_.add({ProblemKind::TaskName, name, {Error::Kind::Schema, where, {}, std::move(message)}});
  };
  const auto id = task_id_of(task.simulator, task.slot);
  if (task.id != id) wrong("has the id " + task.id + ", but its simulator and slot give " + id);
  if (task.scene != task.id) wrong("has the scene " + task.scene + ", which must have the task's id");
  if (task.slot <= last_task_)
    wrong("is of slot " + std::to_string(task.slot) + ", but stands behind slot " + std::to_string(last_task_));
  last_task_ = task.slot;
  Slot& slot = slots_[task.slot];
  slot.filled_by = task.attempt;
  slot.kind = kind_of(task.simulator, task.split);
}

void CandidateCheck::add(const RejectionRecord& rejection, const std::string& where) {
  const auto text = "slot " + std::to_string(rejection.slot);
  Slot& slot = slots_[rejection.slot];
  const int kind = kind_of(rejection.simulator, rejection.split);
  if (slot.kind >= 0 && slot.kind != kind)
    found(where, "is on " + rejection.simulator + " and of the split " + rejection.split +
                     ", unlike another candidate of " + text);
  slot.kind = kind;
  if (rejection.is_by_review()) {
    reviewed_ = true;
    if (slot.filled_by < 0) slot.filled_by = rejection.attempt;  // listed twice: a problem of its own
    return;
  }
  if (reviewed_) found(where, "stands behind tasks that a review took out");
  if (rejection.slot < last_rejected_) found(where, "is of " + text + ", but stands behind a later slot");
  if (rejection.attempt != slot.rejected)
    found(where, "is attempt " + std::to_string(rejection.attempt) + " of " + text + ", expected attempt " +
                     std::to_string(slot.rejected));
  last_rejected_ = rejection.slot;
  slot.rejected = rejection.attempt + 1;
}

ProblemList CandidateCheck::finish(bool complete) {
  if (!complete) return std::move(of_tasks_);
  const auto count_of = [](int rejected) { return std::to_string(rejected) + " rejected candidates"; };
  for (const auto& [number, slot] : slots_) {
    const int wanted = slot.filled_by < 0 ? manifest_.run.attempts : slot.filled_by;
    if (slot.rejected != wanted)
      found("rejections.jsonl", "has " + count_of(slot.rejected) + " of slot " + std::to_string(number) +
                                    ", expected " + std::to_string(wanted));
    if (slot.filled_by >= manifest_.run.attempts)
      found("manifest.json", "allows " + std::to_string(manifest_.run.attempts) + " attempts, but slot " +
                                 std::to_string(number) + " was filled by attempt " + std::to_string(slot.filled_by));
  }
  if (!slots_.empty() && slots_.rbegin()->first >= manifest_.run.count)
    found("manifest.json", "asks for " + std::to_string(manifest_.run.count) + " tasks, but slot " +
                               std::to_string(slots_.rbegin()->first) + " was tried");
  of_tasks_.add(std::move(problems_));
  return std::move(of_tasks_);
}

}  // namespace unietp
