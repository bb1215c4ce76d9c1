#include <algorithm>

#include "logic/comparison.h"
#include "symbolic/goal.h"

namespace unietp::symbolic {
namespace {

int count_true(const Goal& goal, const std::vector<std::size_t>& children, std::size_t from, std::size_t to,
               const Setting& setting, const World& world, const Progress& progress) {
  int number = 0;
  for (std::size_t i = from; i < to; ++i) number += holds(goal, children[i], setting, world, progress) ? 1 : 0;
  return number;
}

}  // namespace

bool holds(const Goal& goal, std::size_t index, const Setting& setting, const World& world, const Progress& progress) {
  const auto& node = goal.node(index);
  const auto holds_child = [&](std::size_t child) { return holds(goal, child, setting, world, progress); };
  switch (node.op) {
    case Goal::Op::Atom:
      return holds(setting, world, node.atom.predicate, node.atom.first, node.atom.second, node.atom.symbol);
    case Goal::Op::And:
      return std::all_of(node.children.begin(), node.children.end(), holds_child);
    case Goal::Op::Or:
      return std::any_of(node.children.begin(), node.children.end(), holds_child);
    case Goal::Op::Not:
      return !holds_child(node.children[0]);
    case Goal::Op::Count: {
      const int number = count_true(goal, node.children, 0, node.children.size(), setting, world, progress);
      return number >= node.least && number <= node.most;
    }
    case Goal::Op::Compare:
      return compares(count_true(goal, node.children, 0, node.split, setting, world, progress), node.comparison,
                      count_true(goal, node.children, node.split, node.children.size(), setting, world, progress));
    case Goal::Op::AtEnd:
      return holds_child(node.children[0]);
    case Goal::Op::Always:
      return progress.part(node.memory) != Progress::Part::Broken;
    case Goal::Op::Sometime:
    case Goal::Op::Until:
    case Goal::Op::Before:
      return progress.part(node.memory) == Progress::Part::Done;
  }
  return false;
}

namespace {

void observe_from(const Goal& goal, std::size_t index, const Setting& setting, const World& world,
                  const Progress& before, std::vector<Progress::Part>& parts) {
  using Part = Progress::Part;
  const auto& node = goal.node(index);
  if (node.op < Goal::Op::Sometime) {
    if (node.op == Goal::Op::AtEnd || node.op == Goal::Op::Atom) return;
    for (const auto child : node.children) observe_from(goal, child, setting, world, before, parts);
    return;
  }
  Part& part = parts[node.memory];
  if (part == Part::Done || part == Part::Broken) return;
  const auto now = [&](std::size_t i) { return holds(goal, node.children[i], setting, world, before); };
  switch (node.op) {
    case Goal::Op::Sometime:
      if (now(0)) part = Part::Done;
      break;
    case Goal::Op::Always:
      if (!now(0)) part = Part::Broken;
      break;
    case Goal::Op::Until:
      part = now(1) ? Part::Done : now(0) ? Part::Open : Part::Broken;
      break;
    default:  // Before: the first time of the first strictly precedes the first time of the second
      if (now(1)) {
        part = part == Part::FirstDone ? Part::Done : Part::Broken;
      } else if (now(0)) {
        part = Part::FirstDone;
      }
  }
}

}  // namespace

Failure Progress::perform(const Goal& goal, const Setting& setting, World& world, const Step& step) {
  std::vector<World> passed;
  const Failure failure = symbolic::perform(setting, world, step, &passed);
  if (failure != Failure::None) return failure;
  for (const World& between : passed) observe(goal, setting, between);
  observe(goal, setting, world);
  return failure;
}

void Progress::observe(const Goal& goal, const Setting& setting, const World& world) {
  auto parts = parts_;
  observe_from(goal, goal.root(), setting, world, *this, parts);
  parts_ = std::move(parts);
}

}  // namespace unietp::symbolic
