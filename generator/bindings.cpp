#include <algorithm>

#include "generator/domain_constraints.h"
#include "generator/specification.h"

namespace unietp {
namespace {

bool is_meant_for(const Template& source, Simulator simulator) {
  return std::find(source.simulators.begin(), source.simulators.end(), simulator) != source.simulators.end();
}

bool is_room(const Parameter& parameter) { return parameter.affordances == std::vector<std::string>{"room"}; }

class BindingSearch {
 public:
  BindingSearch(const Template& source, const Knowledge& knowledge) : source_(source), knowledge_(knowledge) {}

  void restrict_to(const std::vector<std::string>& offered) {
    offered_ = offered;
    std::sort(offered_.begin(), offered_.end());
    for (const auto& type : room_types(knowledge_)) {
      offers_rooms_ = offers_rooms_ || std::binary_search(offered_.begin(), offered_.end(), type);
    }
  }

  void enumerate(std::size_t limit, std::vector<Binding>& found) { extend(limit, nullptr, found); }
  void sample(Rng& rng, std::vector<Binding>& found) { extend(1, &rng, found); }

 private:
  bool is_offered(const Parameter& parameter, const std::string& category) const {
    if (offered_.empty() || (is_room(parameter) && !offers_rooms_)) return true;
    return std::binary_search(offered_.begin(), offered_.end(), category);
  }

  /// Depth first over the parameters. With an rng each level tries its categories in random order, so the first that
  /// can be completed is uniform among those that can.
  void extend(std::size_t limit, Rng* rng, std::vector<Binding>& found) {
    if (found.size() >= limit) return;
    if (binding_.size() == source_.parameters.size()) {
      found.push_back(binding_);
      return;
    }
    const auto& parameter = source_.parameters[binding_.size()];
    auto choices = candidates_for(parameter, source_.constraints, binding_, knowledge_);
    std::erase_if(choices, [&](const std::string& name) { return !is_offered(parameter, name); });
    if (rng != nullptr) rng->shuffle(choices);
    for (const auto& choice : choices) {
      binding_.emplace_back(parameter.name, choice);
      extend(limit, rng, found);
      binding_.pop_back();
      if (found.size() >= limit) return;
    }
  }

  const Template& source_;
  const Knowledge& knowledge_;
  std::vector<std::string> offered_;
  bool offers_rooms_ = false;
  Binding binding_;
};

}  // namespace

std::vector<Binding> enumerate_bindings(const Template& source, const Knowledge& knowledge, std::size_t limit) {
  std::vector<Binding> found;
  if (!is_meant_for(source, knowledge.simulator())) return found;
  BindingSearch(source, knowledge).enumerate(limit, found);
  return found;
}

std::optional<Binding> sample_binding(const Template& source, const Knowledge& knowledge,
                                      const std::vector<std::string>& offered, Rng rng) {
  if (!is_meant_for(source, knowledge.simulator())) return std::nullopt;
  std::vector<Binding> found;
  BindingSearch search(source, knowledge);
  search.restrict_to(offered);
  search.sample(rng, found);
  if (found.empty()) return std::nullopt;
  return found.front();
}

}  // namespace unietp
