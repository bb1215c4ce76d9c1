#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "authoring/trial.h"

namespace unietp {

/// "3 x expert action-failed, such as: …": why some candidates did not become tasks.
std::string text_of(const TemplateTrial::Reason& why);
/// "expert no-plan"
std::string stage_and_name(RejectionReason reason);
/// What most likely has to change when nothing became a task; "" when that is not known.
std::string likeliest_change(const TemplateTrial& trial);
/// The same for programs: a list of objects with stage, reason, count, example and hint.
nlohmann::ordered_json rejections_json(const TemplateTrial& trial);

}  // namespace unietp
