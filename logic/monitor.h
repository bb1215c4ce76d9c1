#pragma once

#include <memory>
#include <string>
#include <vector>

#include "logic/formula.h"
#include "logic/trace.h"

namespace unietp {

/// Evaluates a goal online: after each state it says whether the goal would hold if the trace ended here, how much of
/// it is met and what is missing. It uses formula progression, so the cost of a step depends on the goal and the scene
/// and not on the trace's length. Objects may appear later (slices); quantifiers then range over them too. Copyable, so
/// that a search can branch.
class Monitor {
 public:
  explicit Monitor(const Formula& goal);
  Monitor(const Monitor&);
  Monitor(Monitor&&) noexcept;
  Monitor& operator=(const Monitor&);
  Monitor& operator=(Monitor&&) noexcept;
  ~Monitor();

  /// `entities` is the list so far: it starts with the entities of earlier calls, in the same order.
  void observe(const EntityList& entities, const Facts& facts);

  /// The goal holds if the trace ends with the last observed state.
  bool satisfied() const;
  /// No continuation of the trace can satisfy the goal (sound, not complete: may say false where that is so).
  bool hopeless() const;
  /// In [0, 1]: the share of the goal's parts that are met if the trace ends here; 1 exactly when satisfied.
  double progress() const;
  /// A sentence on what is still missing, naming objects by id ("mug_1 is not on table_2"); "" when satisfied.
  std::string missing() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace unietp
