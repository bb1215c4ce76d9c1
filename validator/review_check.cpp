#include "validator/review_check.h"

#include "record/record_file.h"
#include "record/review_mark_record.h"
#include "record/text_writer.h"
#include "validator/candidate_check.h"

namespace unietp {
namespace {

constexpr const char* kReviewsFile = "reviews.jsonl";

}  // namespace

void ReviewCheck::add(const TaskRecord& task) {
  const auto writer = text_writer_of(task.writer);
  if (writer == TextWriter::Person || writer == TextWriter::UncheckedPerson) edited_.emplace(task.id, task.instruction);
}

void ReviewCheck::add(const RejectionRecord& rejection) {
  if (rejection.is_by_review()) removed_.emplace(task_id_of(rejection.simulator, rejection.slot), rejection.detail);
}

ProblemList ReviewCheck::finish(TaskNames& tasks) {
  ProblemList problems;
  const auto found = [&problems](const std::string& where, std::string message) {
    problems.add(problem_in(ProblemKind::Reviews, where, std::move(message)));
  };
  auto edited = edited_, removed = removed_;
  std::error_code code;
  if (std::filesystem::exists(folder_ / kReviewsFile, code)) {
    auto file = RecordFile<ReviewMarkRecord>::open(folder_, kReviewsFile, FileNames::InFolder, read_review_mark);
    if (!file) {
      problems.add({ProblemKind::Unreadable, "", file.error()});
      return problems;
    }
    std::string last;
    while (const auto line = file->next()) {
      if (!*line) {
        problems.add({ProblemKind::Unreadable, "", line->error()});
        continue;
      }
      const ReviewMarkRecord& mark = **line;
      const auto wrong = [&](std::string message) { found(file->at(), std::move(message)); };
      if (mark.task <= last) wrong("stands behind " + last + "; expected the tasks in order of id, each once");
      last = mark.task;
      const bool there = !tasks.places(mark.task).empty();
      const auto gone = removed.find(mark.task);
      if (!there && gone == removed.end()) wrong("is about " + mark.task + ", which is neither a task nor a rejection");
      if (gone != removed.end()) {
        if (mark.verdict != Judgment::Reject) wrong("is not a rejection, but a review took out " + mark.task);
        if (mark.comment != gone->second) wrong("has a different comment than the rejection of " + mark.task);
        removed.erase(gone);
      }
      const auto own = edited.find(mark.task);
      if (mark.verdict == Judgment::Edit && own == edited.end() && !manifest_.writing)
        wrong("is an edit, but the instruction of " + mark.task + " is not by a person");
      if ((mark.verdict == Judgment::Edit) == mark.before.empty())
        wrong("must have the former text for an edit, and only then");
      if (own != edited.end()) {
        if (mark.before == own->second) wrong("has the present text of " + mark.task + " as the one before the edit");
        edited.erase(own);
      }
    }
  }
  for (const auto& [task, unused] : edited)
    found(kReviewsFile, "lacks the edit of " + task + ", whose text is by a person");
  for (const auto& [task, unused] : removed) found(kReviewsFile, "lacks the decision to take out " + task);
  return problems;
}

}  // namespace unietp
