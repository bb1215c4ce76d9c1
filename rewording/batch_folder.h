#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "annotator/llm_writer.h"
#include "core/folder_lock.h"
#include "llm/batch.h"

namespace unietp {

/// A folder through which a provider's batch service is asked: `requests-0001.jsonl` … are written here,
/// `answers*.jsonl` and whatever else the service gave back (`*.jsonl` that are no requests) is read, in any order.
/// Each run writes only requests that no file has yet, or whose answer failed, so that running again goes on where the
/// answers ended.
class BatchFolder {
 public:
  /// Reads what is there. Errors: Io, also when the folder cannot be written; Usage when another process uses it.
  static Result<BatchFolder> open(const std::filesystem::path& folder, std::string model);

  /// Answers from the files; a request that has none yet is noted.
  std::vector<Result<LlmAnswer>> ask(const std::vector<LlmRequest>& requests);

  struct Report {
    int answered = 0;                              // of the requests that were asked for
    int waiting = 0;                               // in a request file of an earlier run, without an answer
    std::vector<std::string> failed;               // what the service says of those that it gave up
    std::vector<Error> unreadable;                 // lines that are no answers
    std::vector<std::filesystem::path> new_files;  // written now
    int new_requests = 0;                          // in them
  };
  /// Writes what is still to be asked. Errors: Io.
  Result<Report> finish();

 private:
  BatchFolder(FolderLock lock, std::filesystem::path folder, LlmEndpoint endpoint)
      : lock_(std::move(lock)), folder_(std::move(folder)), endpoint_(std::move(endpoint)) {}

  FolderLock lock_;  // or two runs would give their request files the same number
  std::filesystem::path folder_;
  LlmEndpoint endpoint_;
  BatchAnswers answers_;
  std::map<std::string, int> asked_;  // by id: in how many request files
  int files_ = 0;                     // the last request file's number
  std::set<std::string> used_, waiting_;
  std::vector<std::string> failures_, lines_;
};

}  // namespace unietp
