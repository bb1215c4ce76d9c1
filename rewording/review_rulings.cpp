#include "rewording/review_rulings.h"

#include <functional>
#include <set>

#include "annotator/home_facts.h"
#include "core/text.h"
#include "dataset/candidate.h"
#include "rewording/person_text.h"

namespace unietp {
namespace {

/// Decides on each review; the texts of a home stay different.
class Judge {
 public:
  Judge(const std::vector<WordedTask>& tasks, const RulingContext& context) : tasks_(tasks), context_(context) {
    for (std::size_t i = 0; i < tasks.size(); ++i) {
      at_[tasks[i].record.id] = i;
      texts_.insert(key(tasks[i].record.layout, tasks[i].record.instruction));
    }
  }

  Result<std::vector<Ruling>> rulings(const std::vector<Review>& reviews, ApplyReport& report) {
    std::vector<Ruling> rulings(tasks_.size());
    for (const Review& review : reviews) {
      const auto refuse = [&](std::string why) { report.refused.emplace_back(review.task, std::move(why)); };
      const auto found = at_.find(review.task);
      if (found == at_.end()) {
        const auto before = context_.judged_before.find(review.task);
        const bool gone = review.judgement == Judgement::Reject && before != context_.judged_before.end();
        if (gone) continue;  // rejected, and taken out before
        refuse("no such task");
        continue;
      }
      const WordedTask& task = tasks_[found->second];
      const std::string& now = task.record.instruction;
      const bool in_force = review.judgement == Judgement::Edit && now == review.text;
      if (now != review.instruction && !in_force) {
        refuse("its text has changed: \"" + now + "\"");
        continue;
      }
      Ruling& ruling = rulings[found->second];
      if (review.judgement == Judgement::Edit && !in_force) {
        auto text = rewritten(task, now, review.text, refuse);
        if (!text) return text.error();
        if (!*text) continue;
        ruling.rewritten = std::move(*text);
      }
      ruling.review = &review;
      ++(review.judgement == Judgement::Accept   ? report.accepted
         : review.judgement == Judgement::Reject ? report.rejected
                                                 : report.edited);
    }
    return rulings;
  }

 private:
  static std::string key(const std::string& layout, const std::string& text) {
    return layout + "\n" + normalised_text(text);
  }

  /// nullopt when it was refused.
  Result<std::optional<Instruction>> rewritten(const WordedTask& task, const std::string& now, const std::string& text,
                                               const std::function<void(std::string)>& refuse) {
    HomeCache homes(context_.folder);
    const auto scene = read_start(homes, task);
    if (!scene) return scene.error();
    const auto checked =
        check_person_text(text, task, context_.resources.backend(task.specification.simulator), categories_in(*scene));
    if (!checked.faults.empty() && !context_.accept_unchecked) {
      refuse("\"" + text + "\": " + join(checked.faults, "; "));
      return std::optional<Instruction>();
    }
    if (normalised_text(text) != normalised_text(now) && !texts_.insert(key(task.record.layout, text)).second) {
      refuse("\"" + text + "\": another task of this home has this text");
      return std::optional<Instruction>();
    }
    return std::optional(checked.instruction);
  }

  const std::vector<WordedTask>& tasks_;
  const RulingContext& context_;
  std::map<std::string, std::size_t> at_;
  std::set<std::string> texts_;
};

}  // namespace

Result<std::vector<Ruling>> rule_on(const std::vector<Review>& reviews, const std::vector<WordedTask>& tasks,
                                    const RulingContext& context, ApplyReport& report) {
  return Judge(tasks, context).rulings(reviews, report);
}

}  // namespace unietp
