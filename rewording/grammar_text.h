#pragma once

#include <cstdint>
#include <optional>

#include "annotator/instruction.h"
#include "core/result.h"
#include "resources/resources.h"
#include "rewording/worded_task.h"
#include "scene/scene.h"

namespace unietp {

/// How `annotate` has the grammar word a task.
struct GrammarWording {
  Phrasings phrasings = Phrasings::Everyday;
  English english = English::Us;
  std::optional<std::uint64_t> seed;  // without it the run's
};

/// The stream that a task's words are drawn from.
Rng stream_of(const TaskRecord& task, const GrammarWording& wording);

/// The grammar's first text for a task, in its start scene. Deterministic. Errors: those of write_instruction.
Result<Instruction> first_text(const WordedTask& task, const Scene& start, const Resources& resources,
                               const GrammarWording& wording);

/// How many further texts are tried in place of one that another task of the home has, or that misses the style: a goal
/// has tens of texts at least, and a home few tasks of one goal.
inline constexpr std::uint64_t kFurtherTexts = 400;
/// Text number `number` of them, from 1. `in_style`: whether the text before it has the task's style.
Result<Instruction> further_text(const WordedTask& task, const Scene& start, const Resources& resources,
                                 const GrammarWording& wording, std::uint64_t number, bool in_style);

/// The text that the task's record has, made again: the first, or whichever of the further ones it is. The first where
/// it is none of them. Errors: as above, of the first.
Result<Instruction> text_again(const WordedTask& task, const Scene& start, const Resources& resources,
                               const GrammarWording& wording);

}  // namespace unietp
