#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "validator/prove.h"

namespace unietp {

/// Proofs of tasks with the lines that they are of, for whoever validates a folder again after a change: a task whose
/// lines, home and settings are as before is not proven anew. Thread-safe. Memory: all of them.
class ProofMemory {
 public:
  /// The text of all that a proof depends on. `home`: the SHA-256 of its file. `former`: the text before an edit, or
  /// "".
  static std::string key_of(const TaskLines& lines, const std::string& home, const ManifestRecord& manifest,
                            const std::string& former);

  /// nullptr for a key that is not kept.
  std::shared_ptr<const TaskProof> find(const std::string& key) const;
  void keep(const std::string& key, const TaskProof& proof);

 private:
  mutable std::mutex mutex_;
  std::map<std::string, std::shared_ptr<const TaskProof>> proofs_;
};

}  // namespace unietp
