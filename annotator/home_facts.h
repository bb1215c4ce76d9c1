#pragma once

#include <string>
#include <vector>

#include "annotator/noun_table.h"
#include "scene/node_index.h"
#include "scene/scene.h"

namespace unietp {

/// A description of a home for a writer: one line per room with its objects, counted, by display names.
/// "kitchen: 2 mugs, fridge, counter top"
std::string home_in_words(const Scene& scene, const NounTable& nouns);

/// The categories of a scene's objects and the types of its rooms, sorted.
std::vector<std::string> categories_in(const Scene& scene);
/// The same; `places`: of its nodes.
std::vector<std::string> categories_in(const Scene& scene, const NodeIndex& places);
/// Those of them of which the scene has exactly one, sorted: what "the fridge" can mean.
std::vector<std::string> alone_in(const Scene& scene);

}  // namespace unietp
