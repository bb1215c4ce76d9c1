#pragma once

#include <vector>

#include "akb/knowledge.h"
#include "core/rng.h"
#include "generator/specification.h"
#include "logic/trace.h"

namespace unietp {

/// A knowledge base of some twenty categories, written by hand.
Knowledge small_home(Simulator simulator);

/// The templates of the library; fails the test when one does not load.
const std::vector<Template>& library();
const Template& library_template(const std::string& name);

bool supports(const Template& source, Simulator simulator);

/// An independent reading of the constraints of a template over the tables of `knowledge`, by scanning their rows.
bool fits_by_scan(const Template& source, const Binding& binding, const Knowledge& knowledge);

/// Random symbolic starts over the categories of a specification: places and states are drawn blindly and only those
/// that meet `init` are kept. Shares no code with the generator's own sampler.
std::vector<Trace> starts_by_rejection(const Specification& specification, const Knowledge& knowledge, Rng rng,
                                       int tries);

}  // namespace unietp
