#pragma once

#include <string>
#include <vector>

#include "logic/monitor_parts.h"

namespace unietp::monitoring {

/// Reports on the last state: how much of a goal is met and, in English, what is missing.
class Report {
 public:
  Report(const Program& program, const KnownEntities& known, const EntityList& entities, Residuals& residuals)
      : program_(program),
        known_(known),
        entities_(entities),
        residuals_(residuals),
        step_(program, known, residuals) {}

  /// In [0, 1]; 1 exactly when the part holds. And, forall: the mean of the parts; or, exists: the best part; a count:
  /// the best candidates against the number asked for; a temporal formula that does not hold: its operand in the last
  /// state, 0 when it is lost.
  double progress(const Part& part);
  /// The unmet parts, joined by semicolons; at most a handful.
  std::string missing(const Part& part);

 private:
  using Reasons = std::vector<std::string>;

  double share(const Node& node);
  double share_of_sum(const Node& node, const std::vector<double>& shares, int value) const;
  void explain(const Part& part, Reasons& reasons);
  void explain_leaf(const Part& part, Reasons& reasons);
  void explain(const Node& node, Reasons& reasons);
  std::string sum_words(const Node& node, int value) const;
  std::string words(const Node& node) const;
  std::string name(const Node::Argument& argument) const;
  std::string atom_words(const Node& node) const;
  std::string formula_words(const Node& node) const;

  const Program& program_;
  const KnownEntities& known_;
  const EntityList& entities_;
  Residuals& residuals_;
  Progression step_;
};

}  // namespace unietp::monitoring
