#pragma once

#include <filesystem>
#include <vector>

#include "core/result.h"
#include "scene/action.h"
#include "validator/validation_options.h"

namespace unietp {

enum class SftUnit { Episode, Step };              // a sample is a whole demonstration, or one step of it
enum class SftObservation { Boxes, Image, Both };  // in a user's turn; M3 always shows only pictures

/// What samples contain.
struct SftOptions {
  SftUnit unit = SftUnit::Episode;
  SftObservation observation = SftObservation::Boxes;
  bool reasoning = false;
  double mistakes = 0;      // before how many of the steps a wrong action is put (with_mistakes), in [0, 0.5]
  std::vector<Mode> modes;  // empty: all that the data set has and that can be shown
  int threads = 1;
};

/// What was written.
struct SftExport {
  std::size_t samples = 0, pictures = 0, mistakes = 0;
  std::vector<Mode> modes;     // written
  std::vector<Mode> left_out;  // need pictures
};

/// Writes a data set's demonstrations as chats for supervised fine-tuning: `<mode>.jsonl` for LLaMA-Factory, ms-swift
/// and (without pictures) TRL, `<mode>.trl.jsonl` for TRL with pictures, `dataset_info.json`, and `images/` when
/// pictures are asked for. `out` must not exist; it appears as a whole at the end. Equal data sets and options give
/// equal bytes for any number of threads. Errors: those of reading the data set, Io, Usage for a folder that is there
/// or a mode that the data set or the observation does not have.
Result<SftExport> export_sft(const std::filesystem::path& dataset, const std::vector<ValidationBackend>& backends,
                             const SftOptions& options, const std::filesystem::path& out);

}  // namespace unietp
