#include "grounding/spoken_names.h"

namespace unietp {

std::vector<std::string_view> names_of(const Category& category, const Knowledge& knowledge) {
  std::vector<std::string_view> names{category.display, category.plural};
  for (const AliasKind kind : kAliasKinds) {
    for (const Alias* alias : knowledge.aliases_of(category.name, kind)) names.emplace_back(alias->text);
  }
  return names;
}

bool may_mean(std::string_view name, std::string_view other) {
  return other.ends_with(name) && (other.size() == name.size() || other[other.size() - name.size() - 1] == ' ');
}

}  // namespace unietp
