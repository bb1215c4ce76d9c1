#pragma once

#include <string>

#include "akb/knowledge.h"
#include "interchange/format_facts.h"
#include "scene/scene.h"

namespace unietp {

/// A model that stands for a node, and how it lies: the rotation of the model's own frame in the node's.
struct ChosenModel {
  const Asset* asset = nullptr;  // nullptr: none
  Quat turn = Quat::Identity();
};

/// The simulator's model that stands for a node: its own, when the knowledge base has that, else the one of its
/// category whose box is nearest, each extent within a third of the node's or within 5 cm. A movable box, such as a
/// knife, may lie on any of its sides where none fits upright. A model that lacks what its category can do, by
/// FormatFacts::model_lacks, is chosen only where no other fits. Without one, `why` says so, for people.
ChosenModel model_for(const Node& node, const Knowledge& knowledge, const FormatFacts& facts, std::string& why);

}  // namespace unietp
