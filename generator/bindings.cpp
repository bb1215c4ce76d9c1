#include <algorithm>
#include <span>

#include "generator/domain_constraints.h"
#include "generator/weighted_binding.h"

namespace unietp {
namespace {

constexpr int kMostAsked = 4000;  // of wishes; nearly all bindings are found after a few dozen

bool supports(const Template& source, Simulator simulator) {
  return std::find(source.simulators.begin(), source.simulators.end(), simulator) != source.simulators.end();
}

class BindingSearch {
 public:
  BindingSearch(const Template& source, const Knowledge& knowledge) : source_(source), knowledge_(knowledge) {}

  /// Empty: anything. The list, which must outlive the search, is mostly sorted already.
  void restrict_to(const std::vector<std::string>& offered) {
    offered_ = &offered;
    if (!std::is_sorted(offered.begin(), offered.end())) {
      sorted_ = offered;
      std::sort(sorted_.begin(), sorted_.end());
      offered_ = &sorted_;
    }
    const auto& categories = knowledge_.categories();
    offers_rooms_ = std::any_of(categories.begin(), categories.end(), [&](const Category& category) {
      return std::any_of(category.rooms.begin(), category.rooms.end(), [&](const std::string& type) {
        return std::binary_search(offered_->begin(), offered_->end(), type);
      });
    });
  }

  void enumerate(std::size_t limit, std::vector<Binding>& found) { extend(limit, nullptr, found); }
  void sample(Rng& rng, std::vector<Binding>& found) { extend(1, &rng, found); }
  void heed(const BindingWishes& wishes) { wishes_ = &wishes; }

 private:
  const std::string* given_to(const Parameter& parameter) const {
    return wishes_ == nullptr ? nullptr : bound_to(wishes_->fixed, parameter.name);
  }

  /// What the home offers a parameter; nullptr: anything.
  const std::vector<std::string>* offered_to(const Parameter& parameter) const {
    const bool any = given_to(parameter) != nullptr || offered_ == nullptr || offered_->empty() ||
                     is_value(parameter) || (is_room(parameter) && !offers_rooms_);
    return any ? nullptr : offered_;
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
    auto choices = candidates_for(parameter, source_.constraints, binding_, knowledge_, offered_to(parameter));
    if (const auto* given = given_to(parameter))
      std::erase_if(choices, [&](const std::string& name) { return name != *given; });
    std::vector<double> weights;
    if (wishes_ != nullptr && wishes_->weight) {
      for (const auto& choice : choices) weights.push_back(wishes_->weight(parameter, choice));
    } else if (rng != nullptr) {
      rng->shuffle(choices);
    }
    for (std::size_t next = 0; next < choices.size(); ++next) {
      if (!weights.empty()) bring_forward(next, choices, weights, *rng);
      const auto choice = choices[next];
      if (spent()) return;
      if (!accepted(parameter, choice)) continue;
      binding_.emplace_back(parameter.name, choice);
      if (leaves_some_for_the_others()) extend(limit, rng, found);
      binding_.pop_back();
      if (found.size() >= limit) return;
    }
  }

  bool accepted(const Parameter& parameter, const std::string& choice) {
    if (wishes_ == nullptr || !wishes_->accepts) return true;
    ++asked_;
    return wishes_->accepts(binding_, parameter, choice);
  }
  bool spent() const { return asked_ > kMostAsked; }

  /// Whether each later placeholder but the next, which is tried at once, still has an acceptable category. Without
  /// this, a thing that makes no sense at any place would be found out only after all others were tried with it.
  bool leaves_some_for_the_others() {
    if (wishes_ == nullptr || !wishes_->accepts) return true;
    for (std::size_t later = binding_.size() + 1; later < source_.parameters.size(); ++later) {
      const auto& parameter = source_.parameters[later];
      if (given_to(parameter) != nullptr) continue;
      const bool none = each_candidate(parameter, source_.constraints, binding_, knowledge_, offered_to(parameter),
                                       [&](const std::string& choice) { return !accepted(parameter, choice); });
      if (none) return false;
    }
    return true;
  }

  /// Draws which of the choices from `next` on comes first.
  static void bring_forward(std::size_t next, std::vector<std::string>& choices, std::vector<double>& weights,
                            Rng& rng) {
    const auto drawn = next + rng.weighted(std::span(weights).subspan(next));
    std::swap(choices[next], choices[drawn]);
    std::swap(weights[next], weights[drawn]);
  }

  const Template& source_;
  const Knowledge& knowledge_;
  const BindingWishes* wishes_ = nullptr;
  const std::vector<std::string>* offered_ = nullptr;  // sorted
  std::vector<std::string> sorted_;                    // when it was not
  bool offers_rooms_ = false;
  Binding binding_;
  int asked_ = 0;  // categories that the wishes accepted or refused
};

}  // namespace

std::vector<Binding> enumerate_bindings(const Template& source, const Knowledge& knowledge, std::size_t limit) {
  std::vector<Binding> found;
  if (!supports(source, knowledge.simulator())) return found;
  BindingSearch(source, knowledge).enumerate(limit, found);
  return found;
}

std::optional<Binding> sample_binding(const Template& source, const Knowledge& knowledge,
                                      const std::vector<std::string>& offered, Rng rng) {
  if (!supports(source, knowledge.simulator())) return std::nullopt;
  std::vector<Binding> found;
  BindingSearch search(source, knowledge);
  search.restrict_to(offered);
  search.sample(rng, found);
  if (found.empty()) return std::nullopt;
  return found.front();
}

std::optional<Binding> sample_binding(const Template& source, const Knowledge& knowledge,
                                      const std::vector<std::string>& offered, const BindingWishes& wishes, Rng rng) {
  if (!supports(source, knowledge.simulator())) return std::nullopt;
  std::vector<Binding> found;
  BindingSearch search(source, knowledge);
  search.restrict_to(offered);
  search.heed(wishes);
  search.sample(rng, found);
  if (found.empty()) return std::nullopt;
  return found.front();
}

}  // namespace unietp
