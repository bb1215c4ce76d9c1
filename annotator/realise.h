#pragma once

#include <optional>
#include <string>

#include "annotator/noun_table.h"
#include "annotator/plan.h"
#include "core/rng.h"
#include "generator/style.h"

namespace unietp {

/// Words a plan: one of the many texts that say it, drawn by rng. `style`: Direct, Alias, Function or Context (the
/// context sentence is put in front by the caller). `nullopt` when the drawn forms would be ambiguous;
/// another draw may not be.
std::optional<std::string> realise(const Plan& plan, const NounTable& lexicon, Style style, Rng rng);

}  // namespace unietp
