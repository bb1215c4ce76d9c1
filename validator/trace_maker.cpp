#include "validator/trace_maker.h"

namespace unietp {

TraceMaker::TraceMaker(const Scene& start, bool comparisons, bool later)
    : start_(start), later_(later), reader_(comparisons), facts_(reader_.read(start)) {}

Trace TraceMaker::of(std::span<const Delta> changes) const {
  if (later_) return to_logic(start_, {changes.begin(), changes.end()}, true);
  Trace trace;
  trace.states.reserve(changes.size() + 1);
  trace.states.push_back(facts_);
  FactReader reader = reader_;
  for (const Delta& change : changes) trace.states.push_back(reader.read(trace.states.back(), change));
  trace.entities = reader.entities();
  return trace;
}

}  // namespace unietp
