#pragma once

#include "core/result.h"

namespace unietp {

/// Makes failures to write arrive as errors rather than as signals that end the program: a closed pipe, a file that may
/// not grow. Errors: Usage when standard output is closed, before any work is done for it; a closed standard input or
/// error is replaced by nothing, so that no file that is opened later takes its place.
Result<Done> prepare_output();

/// Whether all that was printed arrived. Errors: Io.
Result<Done> finish_output();

}  // namespace unietp
