#pragma once

#include <vector>

#include "symbolic/goal.h"
#include "symbolic/perform.h"

namespace unietp::symbolic {

/// How far it is to a truth, and what to do next.
struct Wish {
  static constexpr int kImpossible = 1000000;
  int cost = 0;             // actions other than going somewhere, as if parts did not get in each other's way
  std::vector<Step> steps;  // first steps of ways to it, each worth a try; empty when it holds or cannot be
  bool possible() const { return cost < kImpossible; }
};

/// Reads off from a world what has to be done next for a truth: the step that brings it about, or, where that step
/// needs something first, the step towards that. An estimate that guides a search: what it says may fail or take more.
class Guide {
 public:
  Guide(const Setting& setting, const Goal& goal) : setting_(setting), goal_(goal) {}

  /// Towards the goal's holding if the trace ends soon after `world`.
  Wish wish(const World& world, const Progress& progress) const;

 private:
  Wish towards(std::size_t node, bool wanted, const World& world, const Progress& progress) const;
  Wish towards_number(const std::vector<std::size_t>& children, int least, int most, const World& world,
                      const Progress& progress) const;
  Wish towards_comparison(const Goal::Node& node, bool wanted, const World& world, const Progress& progress) const;
  Wish towards_moment(const Goal::Node& node, const World& world, const Progress& progress) const;

  const Setting& setting_;
  const Goal& goal_;
};

/// Towards one truth of one world, or, with `wanted` false, away from it.
Wish towards(const Setting& setting, const World& world, const Atom& atom, bool wanted);

/// What one needs after another: costs add up, and what is still to be done of any of them may be done now.
Wish together(Wish first, const Wish& second);
/// One of several ways: the cheapest decides, near ones stay open.
Wish either(const std::vector<Wish>& ways);

}  // namespace unietp::symbolic
