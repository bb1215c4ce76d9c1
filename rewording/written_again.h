#pragma once

#include <map>
#include <optional>

#include "core/result.h"
#include "dataset/candidate.h"
#include "dataset/lines.h"
#include "dataset/manifest.h"
#include "record/manifest_record.h"
#include "record/review_mark_record.h"
#include "record/task_record.h"
#include "record/wordings_record.h"

namespace unietp {

// What was read from a data set, as it is written to another one.

/// A task with an instruction, which may be another one than it had.
TaskEntry written_again(const TaskRecord& task, const Instruction& instruction);
/// A task with its demonstrations.
WrittenTask written_again(const TaskRecord& task, const Instruction& instruction,
                          const std::map<Mode, DemonstrationRecord>& shown);
RejectionEntry written_again(const RejectionRecord& rejection);
/// Errors: Schema for a style that is not known.
Result<WordingsEntry> written_again(const WordingsRecord& wordings);
ReviewMarkEntry written_again(const ReviewMarkRecord& mark);
std::optional<WritingEntry> written_again(const std::optional<RecordedWriting>& writing);

/// Errors: Schema for a configuration or a dimension that is not known; `where` names the manifest.
Result<Manifest> written_again(std::string_view where, const ManifestRecord& manifest);

}  // namespace unietp
