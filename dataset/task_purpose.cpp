#include "dataset/task_purpose.h"

#include <algorithm>

#include "core/text.h"
#include "templates/purpose_reading.h"

namespace unietp {

TaskPurpose purpose_of(const Template& source, const Binding& binding, const Knowledge& knowledge) {
  const auto called = [&](const std::string& placeholder) {
    const auto bound =
        std::find_if(binding.begin(), binding.end(), [&](const auto& b) { return b.first == placeholder; });
    if (bound == binding.end()) return placeholder;
    const auto* category = knowledge.find(bound->second);
    return category == nullptr ? replace_all(bound->second, "_", " ") : category->display;
  };
  TaskPurpose purpose{source.purpose.name, {}};
  for (const auto& need : source.purpose.needs) purpose.because.push_back(need_in_words(need, called));
  return purpose;
}

}  // namespace unietp
