#pragma once

#include <optional>
#include <string>

#include "annotator/clause.h"
#include "annotator/naming.h"
#include "core/rng.h"

namespace unietp {

/// Words for what people say otherwise than clause by clause, without frame or full stop. `nullopt`: the clause is none
/// of these, or the drawn words would be ambiguous.

/// "take all the mugs off the table and put them down", "leave exactly one mug on the table and put the others down",
/// "divide all the mugs between the desk and the shelf, with at least one on each", "put more mugs than plates in the
/// sink", "put the same number of mugs on the desk and on the shelf, with at least one on each", "leave no mug on any
/// table", "pour it into the vase".
std::optional<std::string> idiom(const Clause& clause, Naming& naming);
/// Whether `idiom` is about such a clause.
bool is_idiom(const Clause& clause);
/// Whether a comparison of two numbers is about one place: more mugs than plates in the sink.
bool same_place(const Clause& clause);

/// "put each of the mugs in a cabinet or on a shelf"; nullopt for other clauses.
std::optional<std::string> each_somewhere(const Clause& clause, Naming& naming);

/// "only one can stay on the desk", of what was put somewhere else; nullopt for other clauses.
std::optional<std::string> no_more(const Clause& clause, Naming& naming);

/// What is so the whole time: "leave all the plates on the table", "do not open the fridge".
std::optional<std::string> left_alone(const Clause& clause, Naming& naming);

/// Whether it would be told by the place that it then has to keep, and has no plural: "keep the bread that is on the
/// table on the table".
bool stays_where_it_is_told(const Clause& clause, Naming& naming);

}  // namespace unietp
