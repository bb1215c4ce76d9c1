#include "templates/sections.h"

#include <algorithm>
#include <array>

namespace unietp {
namespace {

constexpr std::array<TemplateSection, 10> kSections = {{
    {SectionType::Name, "name", true, "(name \"open one <A>\")",
     "a title for people, with placeholders in angle brackets"},
    {SectionType::Purpose, "purpose", false, "(purpose cleaning (because (dirty A)))",
     "what the task is for in a home, and what in the start makes it needed"},
    {SectionType::Split, "split", true, "(split atomic)", "the class of the task"},
    {SectionType::Refinement, "refinement", false, "(refinement by-state)", "how its tasks are made harder"},
    {SectionType::Simulators, "simulators", false, "(simulators ai2thor behavior)",
     "the simulators that it supports; default: all four"},
    {SectionType::Parameters, "parameters", true, "(parameters (A - pickupable) ...)",
     "the placeholders, and the requirements on their categories"},
    {SectionType::Constraints, "constraints", false, "(constraints (fits-on A B 2) ...)",
     "constraints between categories"},
    {SectionType::Init, "init", false, "(init f ...)", "what every start must satisfy; grounding makes it true"},
    {SectionType::Goal, "goal", true, "(goal f)", "what must hold on the trace; each part is false at the start"},
    {SectionType::Instruction, "instruction", true, "(instruction \"Open {A:indefinite}.\" ...)",
     "reference phrasings, each with a slot for "
     "every placeholder of the goal"},
}};

constexpr std::array<StartForm, 4> kShapes = {{
    {"(exists (?x - A) body)", "body holds for at least one A"},
    {"(forall (?x - A) body)", "body holds for every A"},
    {"(count >= n (?x - A) body)", "body holds for at least n A"},
    {"(count = n (?x - A) body)", "body holds for exactly n A"},
}};

constexpr std::array<StartForm, 6> kLiterals = {{
    {"(dirty ?x)", "a state of ?x"},
    {"(exists (?y - B) (on ?x ?y))", "a relation of ?x to some B"},
    {"(in_room agent ?x)", "the agent starts in room ?x"},
    {"(not f)", "the negation of one of these"},
    {"(and f g ...)", "a conjunction of these"},
    {"(and)", "no further condition"},
}};

}  // namespace

std::span<const TemplateSection> template_sections() { return kSections; }
const TemplateSection* section_named(std::string_view name) {
  const auto* found =
      std::find_if(kSections.begin(), kSections.end(), [&](const TemplateSection& one) { return one.name == name; });
  return found == kSections.end() ? nullptr : found;
}

std::span<const StartForm> start_shapes() { return kShapes; }
std::span<const StartForm> start_literal_forms() { return kLiterals; }

}  // namespace unietp
