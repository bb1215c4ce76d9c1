#include "authoring/trial_reasons.h"

#include <nlohmann/json.hpp>

namespace unietp {

std::string stage_and_name(RejectionReason reason) {
  return std::string(name_of(stage_of(reason))) + " " + std::string(name_of(reason));
}

std::string text_of(const TemplateTrial::Reason& why) {
  return std::to_string(why.count) + " x " + stage_and_name(why.reason) + ", such as: " + why.example;
}

std::string likeliest_change(const TemplateTrial& trial) {
  if (!trial.tasks.empty() || trial.reasons.empty()) return "";
  return std::string(hint_for(trial.reasons.front().reason));
}

nlohmann::ordered_json rejections_json(const TemplateTrial& trial) {
  auto reasons = nlohmann::ordered_json::array();
  for (const auto& why : trial.reasons)
    reasons.push_back({{"stage", name_of(stage_of(why.reason))},
                       {"reason", name_of(why.reason)},
                       {"count", why.count},
                       {"example", why.example},
                       {"hint", hint_for(why.reason)}});
  return reasons;
}

}  // namespace unietp
