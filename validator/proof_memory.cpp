#include "validator/proof_memory.h"

namespace unietp {
namespace {

void add_line(std::string& key, const std::optional<FileLine>& line) {
  key += line ? std::to_string(line->number) + " " + line->fault + "\n" + line->text : "-";
  key += '\n';
}

/// With which settings the texts are written again.
std::string in_words(const std::optional<RecordedWriting>& writing) {
  if (!writing) return "the run";
  std::string words = writing->writer + " " + (writing->seed ? std::to_string(*writing->seed) : "as the run");
  if (writing->pairs)
    words += " pairs " + std::to_string(writing->pairs->wordings) + (writing->pairs->contrasts ? " contrasts" : "");
  return words;
}

}  // namespace

std::string ProofMemory::key_of(const TaskLines& lines, const std::string& home, const ManifestRecord& manifest,
                                const std::string& former) {
  std::string key = home + " " + manifest.phrasings + " " + manifest.english + " " + in_words(manifest.writing);
  for (const Mode mode : manifest.run.modes) key += " " + std::string(name_of(mode));
  key += '\n' + former + '\n';
  add_line(key, lines.task);
  for (const PartLine& shown : lines.shown) add_line(key, shown.line);
  add_line(key, lines.wordings.line);
  return key;
}

std::shared_ptr<const TaskProof> ProofMemory::find(const std::string& key) const {
  const std::scoped_lock lock(mutex_);
  const auto found = proofs_.find(key);
  return found == proofs_.end() ? nullptr : found->second;
}

void ProofMemory::keep(const std::string& key, const TaskProof& proof) {
  const std::scoped_lock lock(mutex_);
  proofs_.emplace(key, std::make_shared<const TaskProof>(proof));
}

}  // namespace unietp
