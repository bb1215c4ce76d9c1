#include "rewording/accepted_reviews.h"

#include <functional>
#include <set>

#include "core/text.h"
#include "dataset/candidate.h"
#include "rewording/home_texts.h"
#include "rewording/person_text.h"
#include "rewording/worded_task.h"

namespace unietp {
namespace {

/// Decides on each review; the texts of a home stay different.
class Judge {
 public:
  explicit Judge(const ReviewContext& context) : context_(context) {}

  /// Two passes over the tasks: which homes are edited is known after the first.
  Result<Done> read(const std::vector<Review>& reviews) {
    std::map<std::string, Judgment> judged;
    for (const Review& review : reviews) judged.emplace(review.task, review.judgment);
    std::set<std::string> edited;  // homes
    auto read = for_each_worded_task(context_.folder, {}, [&](WordedTask&& task) -> Result<Done> {
      const auto review = judged.find(task.record.id);
      if (review == judged.end()) return Done{};
      if (review->second == Judgment::Edit) edited.insert(task.record.layout);
      tasks_.insert_or_assign(task.record.id, std::move(task));
      return Done{};
    });
    if (!read || edited.empty()) return read;
    return for_each_worded_task(context_.folder, {}, [&](WordedTask&& task) -> Result<Done> {
      if (edited.contains(task.record.layout)) texts_.add(task.record.layout, task.record.instruction);
      return Done{};
    });
  }

  Result<AcceptedReviews> rulings(const std::vector<Review>& reviews, ApplyReport& report) {
    AcceptedReviews rulings;
    for (const Review& review : reviews) {
      const auto refuse = [&](std::string why) { report.refused.emplace_back(review.task, std::move(why)); };
      const auto found = tasks_.find(review.task);
      if (found == tasks_.end()) {
        const auto before = context_.judged_before.find(review.task);
        const bool gone = review.judgment == Judgment::Reject && before != context_.judged_before.end();
        if (gone) continue;  // rejected, and taken out before
        refuse("no such task");
        continue;
      }
      const WordedTask& task = found->second;
      const std::string& now = task.record.instruction;
      const bool in_force = review.judgment == Judgment::Edit && now == review.text;
      if (now != review.instruction && !in_force) {
        refuse("its text has changed: \"" + now + "\"");
        continue;
      }
      AcceptedReview ruling{&review, by_person(task.record.writer), {}};
      if (review.judgment == Judgment::Edit && !in_force) {
        auto text = rewritten(task, now, review.text, refuse);
        if (!text) return text.error();
        if (!*text) continue;
        ruling.rewritten = std::move(*text);
      }
      rulings.insert_or_assign(review.task, std::move(ruling));
      ++(review.judgment == Judgment::Accept   ? report.accepted
         : review.judgment == Judgment::Reject ? report.rejected
                                               : report.edited);
    }
    return rulings;
  }

 private:
  /// nullopt when it was refused.
  Result<std::optional<Instruction>> rewritten(const WordedTask& task, const std::string& now, const std::string& text,
                                               const std::function<void(std::string)>& refuse) {
    HomeCache homes(context_.folder);
    const auto scene = read_start(homes, task);
    if (!scene) return scene.error();
    const Backend& backend = context_.resources.backend(task.specification.simulator);
    const auto checked = check_person_text(text, task, backend, context_.english, *scene);
    if (!checked.faults.empty() && !context_.accept_unchecked) {
      refuse("\"" + text + "\": " + join(checked.faults, "; "));
      return std::optional<Instruction>();
    }
    if (normalized_text(text) != normalized_text(now) && !texts_.add(task.record.layout, text)) {
      refuse("\"" + text + "\": another task of this home has this text");
      return std::optional<Instruction>();
    }
    return std::optional(checked.instruction);
  }

  const ReviewContext& context_;
  std::map<std::string, WordedTask> tasks_;  // that have a review, by id
  HomeTexts texts_;                          // of the homes in which one is to be edited
};

}  // namespace

Result<AcceptedReviews> accept_reviews(const std::vector<Review>& reviews, const ReviewContext& context,
                                       ApplyReport& report) {
  Judge judge(context);
  if (auto read = judge.read(reviews); !read) return read.error();
  return judge.rulings(reviews, report);
}

}  // namespace unietp
