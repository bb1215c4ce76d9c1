#pragma once

#include <optional>
#include <string>

#include "annotator/noun_table.h"
#include "annotator/plan.h"
#include "core/rng.h"

namespace unietp {

/// Words a plan: one of the many texts that say it, drawn by rng. `style`: direct, alias, function or context (the
/// context sentence is put in front by the caller). `nullopt` when the drawn forms cannot say it without a second
/// reading; another draw may.
std::optional<std::string> realise(const Plan& plan, const NounTable& lexicon, const std::string& style, Rng rng);

}  // namespace unietp
