#include "core/text.h"
#include "scores/replayed_episode.h"

namespace unietp {
namespace {

std::string text_of(const std::string& value) { return "\"" + value + "\""; }
std::string text_of(std::string_view value) { return text_of(std::string(value)); }
std::string text_of(bool value) { return value ? "true" : "false"; }
std::string text_of(int value) { return std::to_string(value); }
std::string text_of(std::size_t value) { return std::to_string(value); }
std::string text_of(double value) { return number_text(value); }

class Comparer {
 public:
  template <class T>
  void compare(const std::string& pointer, const T& recorded, const T& replayed) {
    if (!(recorded == replayed)) found_.push_back({pointer, text_of(recorded), text_of(replayed)});
  }

  void compare_action(const std::string& at, const EpisodeAction& recorded, const EpisodeAction& replayed) {
    if (recorded.command != replayed.command)
      found_.push_back({at + "/action", to_text(recorded.command), to_text(replayed.command)});
    compare(at + "/success", recorded.success, replayed.success);
    compare(at + "/failure", recorded.failure, replayed.failure);
    compare(at + "/feedback", recorded.feedback, replayed.feedback);
    compare(at + "/counted", recorded.counted, replayed.counted);
  }

  void compare_step(const std::string& at, const EpisodeStep& recorded, const ReplayedStep& replayed) {
    compare(at + "/unreadable", recorded.unreadable, replayed.unreadable);
    compare(at + "/actions", recorded.actions.size(), replayed.actions.size());
    for (std::size_t i = 0; i < std::min(recorded.actions.size(), replayed.actions.size()); ++i)
      compare_action(at + "/actions/" + std::to_string(i), recorded.actions[i], replayed.actions[i].record);
    if (!replayed.actions.empty()) compare(at + "/progress", recorded.progress, replayed.actions.back().progress);
  }

  std::vector<EpisodeDifference> take() { return std::move(found_); }

 private:
  std::vector<EpisodeDifference> found_;
};

}  // namespace

std::vector<EpisodeDifference> differences(const EpisodeRecord& record, const ReplayedEpisode& replayed,
                                           const EnvironmentTask& task) {
  Comparer comparer;
  comparer.compare("/task", record.key.task, task.text.id);
  comparer.compare<std::string_view>("/simulator", record.simulator, name_of(task.simulator));
  comparer.compare("/split", record.split, task.text.split);
  comparer.compare("/template", record.template_name, task.text.template_name);
  comparer.compare("/layout", record.layout, task.text.layout);
  comparer.compare("/steps", record.steps.size(), replayed.steps.size());
  for (std::size_t i = 0; i < replayed.steps.size(); ++i)
    comparer.compare_step("/steps/" + std::to_string(i), record.steps[i], replayed.steps[i]);
  comparer.compare("/end", name_of(record.end), name_of(replayed.end));
  comparer.compare("/success", record.success, replayed.success);
  comparer.compare("/progress", record.progress, replayed.progress);
  comparer.compare("/counted", record.counted, replayed.counted);
  comparer.compare("/failures", record.failures, replayed.failures);
  return comparer.take();
}

}  // namespace unietp
