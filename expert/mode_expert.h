#pragma once

#include "expert/expert.h"

namespace unietp {

/// Stage: the same goal under the rules of another mode, M2 or M3. What to do to which thing is planned as for M1, but
/// with the actions that the mode offers (the plan of `shown`, the demonstration in M1, where it is one already); how
/// to come to each thing follows the rules: looked for until the camera shows it, gone to only as the mode lets one,
/// and in M3 pointed at with its box in the picture. No step can be left out: without it the goal is not met. Kept only
/// if the goal holds on the executed trace within the limits of the mode. Deterministic. Rejections: stage `expert`,
/// reason `not-in-m2` or `not-in-m3`; the detail says what stood in the way.
std::variant<Demonstration, Rejection> demonstrate_in(Mode mode, Rehearsal& rehearsal, const Demonstration& shown);
std::variant<Demonstration, Rejection> demonstrate_in(Mode mode, const Formula& goal, const Scene& start,
                                                      const Knowledge& knowledge, const Profile& profile,
                                                      const Demonstration& shown);

}  // namespace unietp
