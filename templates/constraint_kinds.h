#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "logic/vocabulary.h"
#include "scene/treatment.h"
#include "templates/template.h"

namespace unietp {

/// One kind of domain constraint: how it is written and which table of the AKB answers it.
struct ConstraintKind {
  enum class Meaning {
    Distinct,   // the placeholders get different categories
    Placement,  // a row of the table of relations: (kind object receptacle [capacity])
    Effect,     // a row of the table of effects: (kind tool target [substance])
    Usual,      // the rooms of `category`: (kind category room)
    Value,      // colors and materials of `category`: (kind category value)
    Sizes,      // `size` and the models: (kind category)
    Words,      // a row of the table of aliases: (kind category synonym|function|context)
    OfKind,     // the kinds of `category`: (kind category kind ...)
    SameKind,   // the kinds of `category`: (kind category category ...)
  };
  ConstraintType type = ConstraintType::Distinct;
  std::string_view name;  // "fits-on"
  Meaning meaning = Meaning::Distinct;
  std::optional<Predicate> relation;   // of Placement
  std::optional<Treatment> treatment;  // of Effect
  std::string_view usage;              // "(fits-on A B [n])"
  std::string_view says;               // one line for people
};

/// All kinds, in the order in which help lists them.
std::span<const ConstraintKind> constraint_kinds();
const ConstraintKind& info(ConstraintType type);
/// nullptr when there is none of that name.
const ConstraintKind* constraint_kind(std::string_view name);

/// "(fits-on A B 2)"
std::string to_text(const DomainConstraint& constraint);

/// A place in a domain constraint or a domain: a placeholder, or what slicing it makes.
struct PlaceholderUse {
  std::string name;    // "A"
  bool slice = false;  // written `A/slice`
};
/// "A/slice" is the placeholder A and a slice.
PlaceholderUse placeholder_use(std::string_view argument);
/// The placeholders that a well-formed constraint speaks of, in order; not its number, nor a substance that it names.
std::vector<PlaceholderUse> placeholders_of(const DomainConstraint& constraint);
/// The capacity that a placement constraint asks for; 1 when it gives none.
int capacity_of(const DomainConstraint& constraint);
/// The substance that an effect constraint asks for, or the placeholder for one; "" when it gives none.
std::string substance_of(const DomainConstraint& constraint);

/// What a parameter may be asked to be besides an affordance of the AKB. From Room on, the only word of a parameter.
enum class ParameterWord : std::uint8_t {
  Furniture,  // stays where it is
  Movable,    // is not furniture
  Countable,  // "two mugs", not "some bread"
  Room,       // a type of room
  Color,      // a word for one; likewise the next two
  Material,
  Substance,
  Any,  // the constraints decide
};
/// nullopt for an affordance of the AKB.
std::optional<ParameterWord> parameter_word(std::string_view word);
/// Whether a parameter asks for this.
bool asks_for(const Parameter& parameter, ParameterWord word);
/// Whether it stands for a color, material or substance, not for a category.
bool is_value(const Parameter& parameter);
/// Whether it stands for a type of room.
bool is_room(const Parameter& parameter);
/// Their names, in the order of the enum.
const std::vector<std::string>& pseudo_affordances();

}  // namespace unietp
