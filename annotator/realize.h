#pragma once

#include <optional>
#include <string>

#include "annotator/naming.h"
#include "annotator/noun_table.h"
#include "annotator/plan.h"
#include "core/rng.h"

namespace unietp {

/// Words a plan: one of the many texts that say it, drawn by rng. A context sentence is put in front by the caller.
/// `nullopt` when the drawn forms would be ambiguous;
/// another draw may not be.
std::optional<std::string> realize(const Plan& plan, const NounTable& lexicon, const Wording& wording, Rng rng);

/// "There is a mug on the desk.", of what stands at one place. `nullopt`: as above.
std::optional<std::string> fact_sentence(const NounPhrase& thing, Naming& naming, Rng& rng);

}  // namespace unietp
