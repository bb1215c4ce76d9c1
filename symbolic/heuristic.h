#pragma once

#include <array>
#include <span>
#include <vector>

#include "symbolic/goal.h"
#include "symbolic/perform.h"

namespace unietp::symbolic {

/// A set of at most 16 steps; further ones are dropped. Stored in place, since a search makes many of these.
class FewSteps {
 public:
  /// Ignored when it is there already or there is no room.
  void add(const Step& step);
  void add(const FewSteps& more);
  bool empty() const { return size_ == 0; }
  std::size_t size() const { return size_; }
  std::span<const Step> all() const { return {steps_.data(), size_}; }

 private:
  std::array<Step, 16> steps_;
  std::size_t size_ = 0;
};

/// An estimate of what makes something true: its cost, and possible next steps.
struct Estimate {
  static constexpr int kImpossible = 1000000;
  int cost = 0;    // actions other than going somewhere, as if parts did not get in each other's way
  FewSteps steps;  // first steps toward it, each worth a try; empty when it holds or cannot be
  bool possible() const { return cost < kImpossible; }
};
inline const Estimate kUnreachable{Estimate::kImpossible, {}};

/// Estimates from a world how to make something true: the step that does it or, if that step has unmet needs, a step
/// toward those. A heuristic for a search: its steps may fail, and its costs may be too low.
class Heuristic {
 public:
  Heuristic(const Setting& setting, const Goal& goal) : setting_(setting), goal_(goal) {}

  /// Of a world in which the goal holds, if the trace ends there.
  Estimate estimate(const World& world, const Progress& progress) const;

 private:
  Estimate toward(std::size_t node, bool wanted, const World& world, const Progress& progress) const;
  Estimate toward_number(const std::vector<std::size_t>& children, int least, int most, const World& world,
                         const Progress& progress) const;
  Estimate toward_comparison(const Goal::Node& node, bool wanted, const World& world, const Progress& progress) const;
  Estimate toward_moment(const Goal::Node& node, const World& world, const Progress& progress) const;

  const Setting& setting_;
  const Goal& goal_;
};

/// Of making one atom true or, with `wanted` false, false.
Estimate toward(const Setting& setting, const World& world, const Atom& atom, bool wanted);

/// Of both, where both are needed: costs add up, and the next steps of either may come first.
Estimate together(Estimate first, const Estimate& second);
/// Estimates of which one is enough: the cost is that of the cheapest; the first steps of the next two are kept too.
class Choice {
 public:
  /// Ignored when it is impossible or costs more than three others.
  void add(const Estimate& way);
  std::size_t size() const { return size_; }  // ways that are possible, at most three
  /// The cheapest way, with the first steps of the others; kUnreachable when there is none.
  Estimate estimate() const;

 private:
  std::array<Estimate, 3> ways_;  // the cheapest first, of equal ones the first that came
  std::size_t size_ = 0;
};

}  // namespace unietp::symbolic
