#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "record/manifest_record.h"
#include "record/task_record.h"
#include "validator/key_list.h"
#include "validator/problem_list.h"

namespace unietp {

/// By task, the texts that edits replaced, as reviews.jsonl says.
using FormerTexts = std::map<std::string, std::string>;
/// Those of a folder, as far as the file can be read; ReviewCheck finds what is wrong with it.
FormerTexts former_texts(const std::filesystem::path& folder);

/// Compares reviews.jsonl with the tasks and the rejections, and with the counts of the manifest: a decision for each
/// task that people edited or took out, in the order of the ids. Which of the tasks that stay were accepted, and what
/// people say of them, follows from nothing.
class ReviewCheck {
 public:
  ReviewCheck(std::filesystem::path folder, const ManifestRecord& manifest)
      : folder_(std::move(folder)), manifest_(manifest) {}

  /// The next task, one that could be read.
  void add(const TaskRecord& task);
  /// The next line of rejections.jsonl, one that could be read.
  void add(const RejectionRecord& rejection);
  /// Texts by people and tasks that they took out.
  int edited() const { return static_cast<int>(edited_.size() + removed_.size()); }
  /// After the last line. `tasks`: the names of all.
  ProblemList finish(TaskNames& tasks);

 private:
  std::filesystem::path folder_;
  const ManifestRecord& manifest_;
  std::map<std::string, std::string> edited_;   // task, its text
  std::map<std::string, std::string> removed_;  // task, the comment
};

}  // namespace unietp
