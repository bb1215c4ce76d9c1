#pragma once

#include <vector>

#include "annotator/clause.h"

namespace unietp {

/// Ways to ask for a state or relation: {s} the subject, {o} the object, {m} the symbol; the plainest first. Empty
/// where only "make sure that …" says it.
std::vector<const char*> verbs(const Complement& said);

}  // namespace unietp
