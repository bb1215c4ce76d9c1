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

/// The folders that are not there yet on the way to one. Those of them that are there and empty when this ends are
/// removed: who fails leaves none behind.
class EmptyFolders {
 public:
  explicit EmptyFolders(const std::filesystem::path& folder);
  EmptyFolders(EmptyFolders&&) = default;
  EmptyFolders& operator=(EmptyFolders&&) = delete;
  ~EmptyFolders();

 private:
  std::vector<std::filesystem::path> missing_;  // the deepest first
};

/// A folder through which a provider's batch service is asked: `requests-0001.jsonl` … are written here,
/// `answers*.jsonl` and whatever else the service gave back (`*.jsonl` that are no requests) is read, in any order.
/// Each run writes only requests that no file has yet, or whose answer failed, so that running again goes on where the
/// answers ended.
class BatchFolder {
 public:
  /// Reads what is there, and makes the folder, which goes again if `finish` writes nothing into it. Errors: Io, also
  /// when the folder cannot be written; Usage when another process uses it.
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
  BatchFolder(EmptyFolders missing, FolderLock lock, std::filesystem::path folder, LlmEndpoint endpoint)
      : missing_(std::move(missing)),
        lock_(std::move(lock)),
        folder_(std::move(folder)),
        endpoint_(std::move(endpoint)) {}

  EmptyFolders missing_;  // ends after the lock, whose file is beside the folder
  FolderLock lock_;       // or two runs would give their request files the same number
  std::filesystem::path folder_;
  LlmEndpoint endpoint_;
  BatchAnswers answers_;
  std::map<std::string, int> asked_;  // by id: in how many request files
  int files_ = 0;                     // the last request file's number
  std::set<std::string> used_, waiting_;
  std::vector<std::string> failures_, lines_;
};

}  // namespace unietp
