#include "templates/sections.h"

#include <array>

namespace unietp {
namespace {

constexpr std::array<TemplateSection, 9> kSections = {{
    {"name", true, "(name \"open one <A>\")", "a title for people, with placeholders in angle brackets"},
    {"split", true, "(split atomic)", "the class of the task"},
    {"refinement", false, "(refinement by-state)", "how its tasks are made harder by default"},
    {"simulators", false, "(simulators ai2thor behavior)", "those whose agent can do it; all four when left out"},
    {"parameters", true, "(parameters (A - pickupable) ...)",
     "the open places, and what a category must be to fill one"},
    {"constraints", false, "(constraints (fits-on A B 2) ...)", "which categories go together"},
    {"init", false, "(init f ...)", "what every start must satisfy; grounding makes it true"},
    {"goal", true, "(goal f)", "what must be true of all that happens, each part false at the start"},
    {"instruction", true, "(instruction \"Open {A:indefinite}.\" ...)",
     "reference phrasings, each with a slot for "
     "every placeholder of the goal"},
}};

constexpr std::array<StartForm, 4> kShapes = {{
    {"(exists (?x - A) body)", "there is an A with this body"},
    {"(forall (?x - A) body)", "every A has this body"},
    {"(count >= n (?x - A) body)", "at least n A have this body"},
    {"(count = n (?x - A) body)", "exactly n A have this body"},
}};

constexpr std::array<StartForm, 6> kLiterals = {{
    {"(dirty ?x)", "a state of ?x"},
    {"(exists (?y - B) (on ?x ?y))", "a relation of ?x to some B"},
    {"(in_room agent ?x)", "the agent starts in room ?x"},
    {"(not f)", "the opposite of one of these"},
    {"(and f g ...)", "several of these"},
    {"(and)", "nothing further"},
}};

}  // namespace

std::span<const TemplateSection> template_sections() { return kSections; }
std::span<const StartForm> start_shapes() { return kShapes; }
std::span<const StartForm> start_literal_forms() { return kLiterals; }

}  // namespace unietp
