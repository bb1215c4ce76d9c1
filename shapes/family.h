#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "logic/vocabulary.h"
#include "scene/states.h"
#include "shapes/piece.h"

namespace unietp {

/// A number of a shape: a constant, a parameter of the family, or a sum, difference, product or quotient.
struct ShapeNumber {
  enum class Kind : std::uint8_t { Constant, Parameter, Sum, Difference, Product, Quotient };
  Kind kind = Kind::Constant;
  double constant = 0;
  std::size_t parameter = 0;       // position in the values that a family is built with
  std::vector<ShapeNumber> parts;  // two or more
};

/// A part of a family, or a group of parts.
struct ShapePart {
  enum class Kind : std::uint8_t {
    Block,
    Drum,
    Ball,
    Capsule,
    Cup,
    Crate,
    Lathe,
    Rod,
    Arc,
    Extrusion,
    Repeat,
    Ring,
    Mirror,
    Turn,
    Hinge,
    Slide,
    Named,
    Paint,
    When,
    Unless
  };
  Kind kind = Kind::Block;
  SourcePos pos;
  std::vector<ShapeNumber> numbers;                        // as the form lists them
  char axis = 'z';                                         // along which a solid stands or a group turns
  std::vector<ShapeNumber> low, high, wall, floor, shift;  // options, empty when not given
  bool screen = false;
  std::vector<std::string> colors;    // of Paint: one of them by seed; "main", "dark" and "light" are the object's
  std::string name;                   // of Named: "lid"
  std::string material;               // of Paint, "" when not given
  Predicate state = Predicate::Open;  // of When and Unless: whether the object has it
  std::vector<ShapePart> parts;       // of groups
};

/// How the axes of a family lie in the box of an object.
enum class ShapeAxes : std::uint8_t {
  Upright,  // x to the right, y to the back, z up
  Tall,     // the same; what is clearly longer than high lies, with z along its longest side
  Wide,     // z up, x along the longer of the others
  Long,     // x along the longest side, z along the shortest
};

/// A kind of shape with parameters that vary from object to object.
struct ShapeFamily {
  struct Parameter {
    std::string name;
    double low = 0, high = 0;
  };
  std::string name, meaning;
  std::string file;
  SourcePos pos;
  ShapeAxes axes = ShapeAxes::Upright;
  bool keeps_body = false;          // drawn around the solids of the archetype
  bool shows_open = false;          // has parts of its own when it is open, or parts that move then
  bool opens = false;               // has parts that move when it is opened
  std::vector<std::string> colors;  // usual ones, of things whose color is not known
  std::string material;             // of things whose material is not known, "" when any
  std::vector<Parameter> parameters;
  std::vector<ShapePart> parts;
};

/// What all families know of the object: its size in meters and the thickness of a hollow's wall, as physics has it.
struct ShapeObject {
  Vec3 size = Vec3::Ones();
  double wall_m = 0.01;
  std::uint32_t seed = 0;  // two objects of a family differ by it
  StateSet states{};
};

/// The pieces of one object. Parameters are drawn by its seed, and the whole is stretched along each axis so that it
/// fills the object's box (families that keep the body are not); what moves when it is opened fills it while it is
/// closed. Pieces without volume are left out. Deterministic.
std::vector<Piece> pieces_of(const ShapeFamily& family, const ShapeObject& object);
/// The names of its parts, in order, each once.
std::vector<std::string> part_names(const ShapeFamily& family);
/// The usual color of an object by its seed, nullptr when the family names none.
const std::string* usual_color(const ShapeFamily& family, std::uint32_t seed);

/// Families of one file. Errors: Parse with line and column; all of them.
struct FamiliesReading {
  std::vector<ShapeFamily> families;
  std::vector<Error> errors;
};
/// `file`: its name, for errors.
FamiliesReading parse_families(std::string_view file, std::string_view text);

/// What is wrong with the shape of a family for such an object, over many seeds: parts without volume, too many pieces,
/// and a whole that has to be stretched by much to fill the object's box.
std::vector<Error> faults_of(const ShapeFamily& family, const Vec3& size, double wall_m);

}  // namespace unietp
