#include "rewording/apply_review.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "core/files.h"
#include "core/staged_folder.h"
#include "dataset/dataset_writer.h"
#include "generator/rejection.h"
#include "record/dataset_reader.h"
#include "record/record_file.h"
#include "record/review_mark_record.h"
#include "record/trait_table.h"
#include "rewording/accepted_reviews.h"
#include "rewording/worded_task.h"
#include "rewording/written_again.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;

constexpr const char* kReviews = "reviews.jsonl";

using Marks = std::map<std::string, ReviewMarkRecord>;  // by task

/// The verdicts that are in force; none where there is no such file.
Result<Marks> read_marks(const fs::path& folder) {
  Marks marks;
  if (std::error_code code; !fs::exists(folder / kReviews, code)) return marks;
  auto file = RecordFile<ReviewMarkRecord>::open(folder, kReviews, FileNames::WithFolder, read_review_mark);
  if (!file) return file.error();
  while (auto mark = file->next()) {
    if (!*mark) return mark->error();
    const std::string task = (*mark)->task;
    if (!marks.emplace(task, std::move(**mark)).second)
      return Error{Error::Kind::Schema, file->at(), {}, "is a second verdict on " + task};
  }
  return marks;
}

/// `earlier`: the text before an earlier edit, or "". Of a text that people edited more than once it is kept, since the
/// others are by people, too.
ReviewMarkRecord mark_of(const AcceptedReview& ruling, const std::string& earlier) {
  const Review& review = *ruling.review;
  ReviewMarkRecord mark{review.task, review.judgment, "", review.comment};
  if (review.judgment != Judgment::Edit) return mark;
  const bool again = ruling.of_person && !earlier.empty() && earlier != review.text;
  mark.before = again ? earlier : review.instruction;
  return mark;
}

ReviewCounts counts_of(const Marks& marks) {
  ReviewCounts counts;
  for (const auto& [task, mark] : marks)
    ++(mark.verdict == Judgment::Accept   ? counts.accepted
       : mark.verdict == Judgment::Reject ? counts.rejected
                                          : counts.edited);
  return counts;
}

RejectionEntry rejection_of(const TaskRecord& task, const Review& review) {
  return {task.slot,
          task.attempt,
          task.template_name,
          task.simulator,
          task.split,
          std::string(name_of(stage_of(RejectionReason::Rejected))),
          std::string(name_of(RejectionReason::Rejected)),
          review.comment};
}

std::vector<Trait> traits_of(const TraitTable::Traits& recorded) {
  std::string text;
  for (const auto& [dimension, value] : recorded) text.append(dimension).append(" ").append(value) += '\n';
  return traits_from(text);
}

/// Every file of a data set, but what nobody here knows.
bool is_made_anew(const std::string& file) {
  for (const char* part : {"homes/", "demonstrations/"}) {
    if (file.starts_with(part)) return true;
  }
  constexpr std::array kNames{"tasks.jsonl", "rejections.jsonl", "dataset.sqlite", "README.md",
                              kManifest,     kReviews,           kWordingsFile};
  return std::find(kNames.begin(), kNames.end(), file) != kNames.end();
}

/// Writes the data set anew, task by task.
class ReviewedSet {
 public:
  ReviewedSet(const fs::path& folder, const fs::path& copy, DatasetWriter writer, TraitTable traits)
      : folder_(folder), copy_(copy), writer_(std::move(writer)), traits_(std::move(traits)) {}

  /// The next task with its ruling.
  Result<Done> add(const FinishedTask& task, const Instruction& instruction, const AcceptedReview& ruling,
                   bool keep_rejected) {
    const auto recorded = traits_.of(++row_, task.record.id);
    if (!recorded) return recorded.error();
    const bool rejected = ruling.review != nullptr && ruling.review->judgment == Judgment::Reject;
    if (rejected && !keep_rejected) {
      rejections_.push_back(rejection_of(task.record, *ruling.review));
      return Done{};
    }
    const auto home_of = [this](const std::string& layout) { return read_file(folder_, home_file(layout)); };
    auto added =
        writer_.add_task(written_again(task.record, ruling.rewritten ? *ruling.rewritten : instruction, task.shown),
                         traits_of(*recorded), home_of);
    if (!added || !task.wordings) return added;
    if (!wordings_) {
      auto begun = LinesWriter::begin(copy_ / kWordingsFile);
      if (!begun) return begun.error();
      wordings_.emplace(std::move(*begun));
    }
    const auto wordings = written_again(*task.wordings);
    if (!wordings) return wordings.error();
    return wordings_->add(line_of(*wordings));
  }

  Result<Done> finish(const Marks& marks, const RunConfiguration& configuration, const Resources& resources,
                      const fs::path& licenses, std::optional<WritingEntry> writing) {
    if (auto done = add_rejections(); !done) return done;
    auto lines = LinesWriter::begin(copy_ / kReviews);
    if (!lines) return lines.error();
    for (const auto& [task, mark] : marks) {
      if (auto added = lines->add(line_of(written_again(mark))); !added) return added;
    }
    if (auto done = lines->finish(); !done) return done;
    if (wordings_) {
      if (auto done = wordings_->finish(); !done) return done;
    }
    return writer_.finish(configuration, resources, licenses, std::move(writing), counts_of(marks));
  }

 private:
  /// The old ones, then those of this review.
  Result<Done> add_rejections() {
    auto old = RecordFile<RejectionRecord>::open(folder_, "rejections.jsonl", FileNames::WithFolder, read_rejection);
    if (!old) return old.error();
    while (const auto rejection = old->next()) {
      if (!*rejection) return rejection->error();
      if (auto done = writer_.add_rejection(written_again(**rejection)); !done) return done;
    }
    for (const auto& rejection : rejections_) {
      if (auto done = writer_.add_rejection(rejection); !done) return done;
    }
    return Done{};
  }

  const fs::path& folder_;
  const fs::path& copy_;
  DatasetWriter writer_;
  TraitTable traits_;
  std::int64_t row_ = 0;
  std::vector<RejectionEntry> rejections_;
  std::optional<LinesWriter> wordings_;
};

}  // namespace

Result<ApplyReport> apply_review(const fs::path& folder, const fs::path& out, const std::vector<Review>& reviews,
                                 const Resources& resources, const ApplyOptions& options) {
  auto copy = ChangedCopy::begin(folder, out, is_made_anew);  // first, so that the folder stays as it is read
  if (!copy) return copy.error();
  const auto recorded = read_manifest_file(folder);
  if (!recorded) return recorded.error();
  const auto where = (folder / kManifest).string();
  if (recorded->knowledge_digest != resources.digest)
    return Error{Error::Kind::Usage,
                 where,
                 {},
                 "was made with different tables, profiles, layouts or templates; select the right ones "
                 "with --data"};
  const auto manifest = written_again(where, *recorded);
  if (!manifest) return manifest.error();
  auto marks = read_marks(folder);
  if (!marks) return marks.error();
  auto traits = TraitTable::open(folder / "dataset.sqlite");
  if (!traits) return traits.error();

  ApplyReport report;
  const auto rulings = accept_reviews(
      reviews, {folder, resources, recorded_english(recorded->english), options.accept_unchecked, *marks}, report);
  if (!rulings) return rulings.error();
  for (const auto& [task, ruling] : *rulings) {
    auto& mark = (*marks)[task];
    mark = mark_of(ruling, mark.before);
  }
  auto writer = DatasetWriter::begin(copy->folder());
  if (!writer) return writer.error();
  auto reader = DatasetReader::open(folder, all_lines(folder));
  if (!reader) return reader.error();
  ReviewedSet set(folder, copy->folder(), std::move(*writer), std::move(*traits));
  int line = 0;
  const auto added = for_each_task<Done>(
      std::move(*reader), 1,
      [&](const FinishedTask& task) -> Result<Done> {
        const auto worded = worded_task(folder, ++line, task.record);
        if (!worded) return worded.error();
        const auto ruling = rulings->find(task.record.id);
        return set.add(task, instruction_of(*worded), ruling == rulings->end() ? AcceptedReview() : ruling->second,
                       options.keep_rejected);
      },
      [](Done&&) -> Result<Done> { return Done{}; });
  if (!added) return added.error();
  if (auto done = set.finish(*marks, manifest->configuration, resources, options.licenses, manifest->writing); !done)
    return done.error();
  if (auto done = copy->finish(); !done) return done.error();
  return report;
}

}  // namespace unietp
