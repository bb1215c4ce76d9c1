#pragma once

#include <functional>
#include <string>
#include <vector>

#include "akb/knowledge.h"
#include "generator/specification.h"
#include "templates/constraint_kinds.h"

namespace unietp {

/// The types of room that the knowledge base names, sorted: what a placeholder `(R - room)` may become.
std::vector<std::string> room_types(const Knowledge& knowledge);

/// Whether a category (a room type, for `room`; a word, for `color`, `material`, `substance`) has everything that the
/// parameter asks for.
bool affords(const Parameter& parameter, const std::string& category, const Knowledge& knowledge);

/// The categories of the pieces that slicing makes, sorted; the category itself when its slices have none of their own.
std::vector<std::string> slices_of(const std::string& category, const Knowledge& knowledge);

/// The category bound to a placeholder; nullptr when it is not bound yet.
const std::string* bound_to(const Binding& binding, const std::string& placeholder);

/// Whether the constraint holds. All its placeholders are bound.
bool satisfies(const DomainConstraint& constraint, const Binding& binding, const Knowledge& knowledge);

/// "(fits-on A B 2)" with what is bound: "(fits-on Mug Shelf 2)".
std::string to_text(const DomainConstraint& constraint, const Binding& binding);

/// Categories for a parameter that afford what it asks for and satisfy each constraint whose other placeholders are
/// bound, sorted; only those of `among`, which is sorted, when it is given.
std::vector<std::string> candidates_for(const Parameter& parameter, const std::vector<DomainConstraint>& constraints,
                                        const Binding& binding, const Knowledge& knowledge,
                                        const std::vector<std::string>* among = nullptr);
/// Visits them one after the other until a visit gives false; whether none did.
bool each_candidate(const Parameter& parameter, const std::vector<DomainConstraint>& constraints,
                    const Binding& binding, const Knowledge& knowledge, const std::vector<std::string>* among,
                    const std::function<bool(const std::string& category)>& visit);

}  // namespace unietp
