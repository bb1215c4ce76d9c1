#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "akb/knowledge.h"
#include "annotator/noun_table.h"
#include "core/rng.h"
#include "generator/specification.h"
#include "scene/scene.h"

namespace unietp {

/// What a language model gets of a task whose instruction it writes.
struct WordingTask {
  Specification specification;
  const Knowledge* knowledge = nullptr;
  const NounTable* nouns = nullptr;     // of the knowledge base
  std::vector<std::string> categories;  // in the start scene, sorted: what a text may speak of
  std::shared_ptr<const Scene> home;    // the start scene; none: nothing is known of it
  std::string facts;                    // of the start scene, for people: "kitchen: fridge, 2 mugs (1 dirty)"
  std::span<const std::string> phrasings_of_template = {};  // as in WritingOptions
  Rng rng{0};                                               // of the grammar's text, which is the fallback
};

}  // namespace unietp
