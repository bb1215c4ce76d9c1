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

/// Folders that this process made on the way to one. Those of them that are empty when this ends are removed: who fails
/// leaves none behind but those in which another process made something, and nobody removes what another process made.
class MadeFolders {
 public:
  /// Makes `folder` and what is missing above it. Errors: Io.
  static Result<MadeFolders> make(const std::filesystem::path& folder);
  MadeFolders(MadeFolders&&) = default;
  MadeFolders& operator=(MadeFolders&&) = delete;
  ~MadeFolders();

 private:
  MadeFolders() = default;
  std::vector<std::filesystem::path> made_;  // the deepest last
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
  BatchFolder(MadeFolders around, FolderLock lock, MadeFolders own, std::filesystem::path folder, LlmEndpoint endpoint)
      : around_(std::move(around)),
        lock_(std::move(lock)),
        own_(std::move(own)),
        folder_(std::move(folder)),
        endpoint_(std::move(endpoint)) {}

  MadeFolders around_;  // ends after the lock, whose file is in one of them
  FolderLock lock_;     // or two runs would give their request files the same number
  MadeFolders own_;     // ends before the lock: another run may have the folder from then on
  std::filesystem::path folder_;
  LlmEndpoint endpoint_;
  BatchAnswers answers_;
  std::map<std::string, int> asked_;  // by id: in how many request files
  int files_ = 0;                     // the last request file's number
  std::set<std::string> used_, waiting_;
  std::vector<std::string> failures_, lines_;
};

}  // namespace unietp
