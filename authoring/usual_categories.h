#pragma once

#include <map>
#include <string>
#include <vector>

#include "resources/resources.h"

namespace unietp {

/// The categories of a simulator that some template of the library can be about with a goal that makes usual sense,
/// whatever homes offer; in the order of the knowledge base. Of each template as many other categories are tried as a
/// run tries. Deterministic. Takes about a minute for all simulators.
std::vector<std::string> categories_with_usual_goals(const Resources& resources, Simulator simulator);

/// The templates that can be about a category with a goal that makes usual sense; in the order of the library.
std::vector<std::string> templates_with_usual_goals(const std::string& category, const Resources& resources,
                                                    Simulator simulator);

/// The templates of which a placeholder can be this movable category and no other with a goal that makes usual sense:
/// however evenly goals are chosen, each task of theirs is about it. Names in the order of the library, by category.
std::map<std::string, std::vector<std::string>> templates_of_one_category(const Resources& resources,
                                                                          Simulator simulator);

}  // namespace unietp
