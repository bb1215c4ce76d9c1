#pragma once

#include <optional>
#include <string>

#include "annotator/clause.h"
#include "annotator/naming.h"
#include "core/rng.h"

namespace unietp {

/// Words a proposition, without frame or full stop: each operator in front of what it is about, so that there is one
/// reading however they nest. What it speaks of and does not bind was named before. `nullopt` when something has no
/// name of its own.
std::optional<std::string> proposition_words(const Proposition& said, Naming& naming, Rng& rng);

}  // namespace unietp
