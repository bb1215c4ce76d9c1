#include "generator/propose.h"
#include "generator/specification.h"

namespace unietp {

Result<Specification> instantiate(const Template& source, const Knowledge& knowledge, const Binding& binding) {
  auto proposed = propose(source, knowledge, binding);
  if (const auto* refusal = std::get_if<GateRefusal>(&proposed)) {
    return Error{Error::Kind::Unsatisfiable, source.name, {}, refusal->reason};
  }
  return std::get<Specification>(std::move(proposed));
}

}  // namespace unietp
