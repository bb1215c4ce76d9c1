#pragma once

#include <map>
#include <string>

namespace unietp {

/// What a formula of ltlf_goal asks of the last state, in BDDL.
struct LastState {
  std::string text;  // "true" when it asks nothing of it
  /// Whether the last state alone decides the formula. Otherwise what is asked is necessary and not enough.
  bool decides = true;
};

/// `formula`: of ltlf_goal; `literals`: the BDDL of each proposition that it names; `lasting`: whether a proposition
/// that holds once holds ever after. Pure.
LastState last_state_of(const std::string& formula, const std::map<std::string, std::string>& literals,
                        bool (*lasting)(const std::string& proposition));

}  // namespace unietp
