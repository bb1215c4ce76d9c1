#include "validator/review_check.h"

#include "record/record_file.h"
#include "record/review_mark_record.h"
#include "record/text_writer.h"
#include "validator/candidate_check.h"

namespace unietp {
namespace {

constexpr const char* kReviewsFile = "reviews.jsonl";

bool has_reviews(const std::filesystem::path& folder) {
  std::error_code code;
  return std::filesystem::exists(folder / kReviewsFile, code);
}

auto open_reviews(const std::filesystem::path& folder) {
  return RecordFile<ReviewMarkRecord>::open(folder, kReviewsFile, FileNames::InFolder, read_review_mark);
}

std::string in_words(const RecordedReviews& counts) {
  return std::to_string(counts.accepted) + " accepted, " + std::to_string(counts.rejected) + " rejected and " +
         std::to_string(counts.edited) + " edited";
}

}  // namespace

FormerTexts former_texts(const std::filesystem::path& folder) {
  FormerTexts former;
  if (!has_reviews(folder)) return former;
  auto file = open_reviews(folder);
  while (file) {
    const auto line = file->next();
    if (!line) break;
    if (*line && !(*line)->before.empty()) former[(*line)->task] = (*line)->before;
  }
  return former;
}

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
  RecordedReviews counts;
  if (has_reviews(folder_)) {
    auto file = open_reviews(folder_);
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
      ++(mark.verdict == Judgment::Accept   ? counts.accepted
         : mark.verdict == Judgment::Reject ? counts.rejected
                                            : counts.edited);
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
  const auto recorded = manifest_.reviews.value_or(RecordedReviews());
  if (recorded != counts || manifest_.reviews.has_value() != has_reviews(folder_))
    found(kReviewsFile, "has " + in_words(counts) + ", but the manifest says " +
                            (manifest_.reviews ? in_words(recorded) : std::string("of no reviews")));
  for (const auto& [task, unused] : edited)
    found(kReviewsFile, "lacks the edit of " + task + ", whose text is by a person");
  for (const auto& [task, unused] : removed) found(kReviewsFile, "lacks the decision to take out " + task);
  return problems;
}

}  // namespace unietp
