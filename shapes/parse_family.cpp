#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include "core/in_quotes.h"
#include "core/limits.h"
#include "core/sexpr.h"
#include "core/text.h"
#include "shapes/family.h"
#include "shapes/known_values.h"

namespace unietp {
namespace {

using Kind = ShapePart::Kind;

/// A form of the language: how many numbers it has, and whether parts follow.
struct Form {
  std::string_view word;
  Kind kind = Kind::Block;
  std::size_t least = 0, most = 0;  // numbers
  bool group = false;
  std::string_view numbers;  // for messages
};

constexpr std::size_t kAny = limits::kShapeNumbers;
constexpr std::array<Form, 20> kForms{{
    {"box", Kind::Block, 6, 6, false, "x0 x1 y0 y1 z0 z1"},
    {"drum", Kind::Drum, 6, 6, false, "x0 x1 y0 y1 z0 z1"},
    {"ball", Kind::Ball, 6, 6, false, "x0 x1 y0 y1 z0 z1"},
    {"capsule", Kind::Capsule, 6, 6, false, "x0 x1 y0 y1 z0 z1"},
    {"cup", Kind::Cup, 6, 6, false, "x0 x1 y0 y1 z0 z1"},
    {"crate", Kind::Crate, 6, 6, false, "x0 x1 y0 y1 z0 z1"},
    {"lathe", Kind::Lathe, 4, kAny, false, "z r for each ring, from below"},
    {"rod", Kind::Rod, 7, 8, false, "x y z of both ends and one or two radii"},
    {"arc", Kind::Arc, 9, 9, false, "cx cy cz ra rb from to steps radius"},
    {"extrusion", Kind::Extrusion, 8, kAny, false, "its ends and a b of three or more corners"},
    {"repeat", Kind::Repeat, 4, 4, true, "times dx dy dz"},
    {"ring", Kind::Ring, 1, 1, true, "times"},
    {"mirror", Kind::Mirror, 0, 0, true, ""},
    {"turn", Kind::Turn, 4, 4, true, "degrees cx cy cz"},
    {"hinge", Kind::Hinge, 4, 4, true, "degrees cx cy cz"},
    {"slide", Kind::Slide, 3, 3, true, "dx dy dz"},
    {"part", Kind::Named, 0, 0, true, ""},
    {"paint", Kind::Paint, 0, 0, true, ""},
    {"when", Kind::When, 0, 0, true, ""},
    {"unless", Kind::Unless, 0, 0, true, ""},
}};

std::optional<double> number_in(const std::string& text) {
  double value = 0;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (failure != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  if (std::abs(value) > limits::kShapeNumber) return std::nullopt;
  return value;
}

std::string word_of(const Sexpr& form) {
  return form.is_list() && !form.children.empty() && form.children.front().is_atom() ? form.children.front().text : "";
}

class Reader {
 public:
  Reader(std::string_view file, std::vector<Error>& errors) : file_(file), errors_(errors) {}

  ShapeFamily family(const Sexpr& form) {
    ShapeFamily family;
    family.file = file_;
    family.pos = form.pos;
    parameters_.assign(kKnownValues.begin(), kKnownValues.end());
    shows_open_ = opens_ = false;
    if (form.children.size() < 2 || !form.children[1].is_atom()) {
      fail(form.pos, "expected a name after \"family\"");
      return family;
    }
    family.name = form.children[1].text;
    for (std::size_t i = 2; i < form.children.size(); ++i) {
      const Sexpr& child = form.children[i];
      if (!head(child, family)) family.parts.push_back(part(child));
    }
    family.shows_open = shows_open_ || opens_;
    family.opens = opens_;
    if (family.meaning.empty()) fail(form.pos, "needs (means \"…\"): what the family shows");
    if (family.parts.empty() && !family.keeps_body) fail(form.pos, "has no part");
    return family;
  }

 private:
  void fail(const SourcePos& pos, std::string message) {
    errors_.push_back({Error::Kind::Parse, std::string(file_), pos, std::move(message)});
  }

  /// Reads a form that is no part; false when it is a part.
  bool head(const Sexpr& form, ShapeFamily& family) {
    const std::string word = word_of(form);
    if (word == "means") {
      const bool sound = form.children.size() == 2 && form.children[1].kind == Sexpr::Kind::String;
      sound ? void(family.meaning = form.children[1].text) : fail(form.pos, "expected (means \"…\")");
    } else if (word == "axes") {
      axes(form, family.axes);
    } else if (word == "body") {
      family.keeps_body = true;
      if (form.children.size() != 1) fail(form.pos, "expected (body)");
    } else if (word == "colours") {
      for (std::size_t i = 1; i < form.children.size(); ++i) family.colors.push_back(color(form.children[i], false));
      if (family.colors.empty()) fail(form.pos, "expected names of colors");
    } else if (word == "material") {
      if (form.children.size() != 2) return fail(form.pos, "expected (material NAME)"), true;
      family.material = material(form.children[1]);
    } else if (word == "param") {
      parameter(form, family);
    } else {
      return false;
    }
    return true;
  }

  void axes(const Sexpr& form, ShapeAxes& axes) {
    const std::string name = form.children.size() == 2 ? form.children[1].text : "";
    if (name == "upright") {
      axes = ShapeAxes::Upright;
    } else if (name == "tall") {
      axes = ShapeAxes::Tall;
    } else if (name == "wide") {
      axes = ShapeAxes::Wide;
    } else if (name == "long") {
      axes = ShapeAxes::Long;
    } else {
      fail(form.pos, "expected (axes upright), (axes tall), (axes wide) or (axes long)");
    }
  }

  void parameter(const Sexpr& form, ShapeFamily& family) {
    const auto& children = form.children;
    const auto value = [&](std::size_t i) {
      return i < children.size() && children[i].is_atom() ? number_in(children[i].text) : std::nullopt;
    };
    const auto low = value(2), high = value(3);
    if (children.size() != 4 || !children[1].is_atom() || !low || !high || *low > *high)
      return fail(form.pos, "expected (param NAME LOW HIGH) with LOW at most HIGH");
    if (std::find(parameters_.begin(), parameters_.end(), children[1].text) != parameters_.end())
      return fail(children[1].pos, in_quotes(children[1].text) + " is a parameter already");
    parameters_.push_back(children[1].text);
    family.parameters.push_back({children[1].text, *low, *high});
  }

  std::string color(const Sexpr& atom, bool relative) {
    const bool known =
        atom.is_atom() &&
        (color_named(atom.text) != nullptr ||
         (relative && std::find(kRelativeColors.begin(), kRelativeColors.end(), atom.text) != kRelativeColors.end()));
    if (!known)
      fail(atom.pos, "expected a color" + std::string(relative ? ", \"main\", \"dark\" or \"light\"" : "") +
                         nearest(atom.text, color_names()));
    return atom.text;
  }
  std::string material(const Sexpr& atom) {
    if (!atom.is_atom() || material_named(atom.text) == nullptr)
      fail(atom.pos, "expected a material" + nearest(atom.text, material_names()));
    return atom.text;
  }
  static std::string nearest(const std::string& text, const std::vector<std::string>& names) {
    const std::string name = nearest_name(text, names);
    return name.empty() ? ": one of " + join(names, ", ") : "; did you mean \"" + name + "\"?";
  }

  ShapeNumber number(const Sexpr& expression) {
    ShapeNumber number;
    if (expression.is_atom()) {
      if (const auto value = number_in(expression.text)) {
        number.constant = *value;
        return number;
      }
      const auto found = std::find(parameters_.begin(), parameters_.end(), expression.text);
      if (found == parameters_.end()) {
        fail(expression.pos, "expected a number or a parameter" + nearest(expression.text, parameters_));
      }
      number.kind = ShapeNumber::Kind::Parameter;
      number.parameter = static_cast<std::size_t>(found - parameters_.begin());
      return number;
    }
    constexpr std::string_view kOperators = "+-*/";
    const std::string word = word_of(expression);
    const auto which = word.size() == 1 ? kOperators.find(word) : std::string_view::npos;
    if (which == std::string_view::npos || expression.children.size() < 3) {
      fail(expression.pos, "expected a number, a parameter or (+ a b), (- a b), (* a b), (/ a b)");
      return number;
    }
    number.kind = static_cast<ShapeNumber::Kind>(static_cast<int>(ShapeNumber::Kind::Sum) + static_cast<int>(which));
    for (std::size_t i = 1; i < expression.children.size(); ++i)
      number.parts.push_back(this->number(expression.children[i]));
    return number;
  }

  static bool is_number(const Sexpr& child) {
    if (child.is_atom()) return true;
    const std::string word = word_of(child);
    return word == "+" || word == "-" || word == "*" || word == "/";
  }

  std::vector<ShapeNumber> option(const Sexpr& form, std::size_t least, std::size_t most) {
    std::vector<ShapeNumber> numbers;
    for (std::size_t i = 1; i < form.children.size(); ++i) numbers.push_back(number(form.children[i]));
    if (numbers.size() < least || numbers.size() > most)
      fail(form.pos, "expected " + std::to_string(least) + " to " + std::to_string(most) + " numbers after " +
                         in_quotes(word_of(form)));
    return numbers;
  }

  bool read_option(const Sexpr& form, ShapePart& part) {
    const std::string word = word_of(form);
    if (word == "low") {
      part.low = option(form, 1, 2);
    } else if (word == "high") {
      part.high = option(form, 1, 2);
    } else if (word == "shift" || word == "at") {
      part.shift = option(form, 2, 2);
    } else if (word == "wall") {
      part.wall = option(form, 1, 1);
    } else if (word == "floor") {
      part.floor = option(form, 1, 1);
    } else if (word == "screen") {
      part.screen = true;
    } else if (word == "axis") {
      const std::string name = form.children.size() == 2 ? form.children[1].text : "";
      if (name != "x" && name != "y" && name != "z")
        return fail(form.pos, "expected (axis x), (axis y) or (axis z)"), true;
      part.axis = name.front();
    } else {
      return false;
    }
    return true;
  }

  ShapePart part(const Sexpr& form) {
    ShapePart part;
    part.pos = form.pos;
    const std::string word = word_of(form);
    const auto* const known =
        std::find_if(kForms.begin(), kForms.end(), [&](const Form& one) { return one.word == word; });
    if (known == kForms.end()) {
      std::vector<std::string> words;
      for (const Form& one : kForms) words.emplace_back(one.word);
      fail(form.pos, "expected a part" + nearest(word, words));
      return part;
    }
    if (++parts_ > limits::kShapeParts) {
      if (parts_ == limits::kShapeParts + 1)
        fail(form.pos, "a file has at most " + std::to_string(limits::kShapeParts) + " parts");
      return part;
    }
    part.kind = known->kind;
    std::size_t i = 1;
    if (part.kind == Kind::Paint) i = paint(form, part);
    if (part.kind == Kind::Mirror || part.kind == Kind::Turn || part.kind == Kind::Hinge) i = axis(form, part);
    opens_ = opens_ || part.kind == Kind::Hinge || part.kind == Kind::Slide;
    if (part.kind == Kind::When || part.kind == Kind::Unless) i = condition(form, part);
    if (part.kind == Kind::Named) i = name(form, part);
    for (; i < form.children.size() && is_number(form.children[i]); ++i)
      part.numbers.push_back(number(form.children[i]));
    if (part.numbers.size() < known->least || part.numbers.size() > known->most ||
        ((part.kind == Kind::Lathe || part.kind == Kind::Extrusion) && part.numbers.size() % 2 != 0))
      fail(form.pos, in_quotes(word) + " needs " + std::string(known->numbers));
    for (; i < form.children.size(); ++i) {
      if (read_option(form.children[i], part)) continue;
      if (known->group) {
        part.parts.push_back(this->part(form.children[i]));
      } else {
        fail(form.children[i].pos,
             "expected (low …), (high …), (shift …), (at …), (wall …), (floor …), (axis …) or (screen)");
      }
    }
    if (known->group && part.parts.empty()) fail(form.pos, in_quotes(word) + " has no part");
    return part;
  }

  std::size_t paint(const Sexpr& form, ShapePart& part) {
    std::size_t i = 1;
    if (i < form.children.size() && form.children[i].is_form("any")) {
      const auto& list = form.children[i].children;
      for (std::size_t k = 1; k < list.size(); ++k) part.colors.push_back(color(list[k], true));
      ++i;
    } else if (i < form.children.size() && form.children[i].is_atom()) {
      part.colors.push_back(color(form.children[i], true));
      ++i;
    }
    if (part.colors.empty()) fail(form.pos, "expected a color after \"paint\", or (any COLOR…)");
    if (i < form.children.size() && form.children[i].is_atom()) part.material = material(form.children[i++]);
    return i;
  }

  std::size_t condition(const Sexpr& form, ShapePart& part) {
    const bool given = form.children.size() > 1 && form.children[1].is_atom();
    const auto state = given ? predicate_named(form.children[1].text) : std::nullopt;
    if (!state) {
      fail(form.pos, "expected a state such as \"open\" after " + in_quotes(word_of(form)));
      return given ? 2 : 1;
    }
    part.state = *state;
    shows_open_ = shows_open_ || *state == Predicate::Open;
    return 2;
  }

  std::size_t name(const Sexpr& form, ShapePart& part) {
    if (form.children.size() < 2 || !form.children[1].is_atom() || number_in(form.children[1].text)) {
      fail(form.pos, "expected a name after \"part\"");
      return 1;
    }
    part.name = form.children[1].text;
    return 2;
  }

  std::size_t axis(const Sexpr& form, ShapePart& part) {
    const std::string name = form.children.size() > 1 && form.children[1].is_atom() ? form.children[1].text : "";
    if (name != "x" && name != "y" && name != "z") {
      fail(form.pos, "expected x, y or z after " + in_quotes(word_of(form)));
      return 1;
    }
    part.axis = name.front();
    return 2;
  }

  std::string_view file_;
  std::vector<Error>& errors_;
  std::vector<std::string> parameters_;
  std::size_t parts_ = 0;
  bool shows_open_ = false, opens_ = false;  // of the present family
};

}  // namespace

std::vector<std::string> part_names(const ShapeFamily& family) {
  std::vector<std::string> names;
  const auto gather = [&](auto& self, const std::vector<ShapePart>& parts) -> void {
    for (const ShapePart& part : parts) {
      if (!part.name.empty() && std::find(names.begin(), names.end(), part.name) == names.end())
        names.push_back(part.name);
      self(self, part.parts);
    }
  };
  gather(gather, family.parts);
  return names;
}

FamiliesReading parse_families(std::string_view file, std::string_view text) {
  FamiliesReading reading;
  const auto forms = read_sexprs(file, text);
  if (!forms) {
    reading.errors.push_back(forms.error());
    return reading;
  }
  Reader reader(file, reading.errors);
  for (const Sexpr& form : *forms) {
    if (form.is_form("family")) {
      reading.families.push_back(reader.family(form));
    } else {
      reading.errors.push_back({Error::Kind::Parse, std::string(file), form.pos, "expected (family NAME …)"});
    }
  }
  if (!reading.errors.empty()) reading.families.clear();
  return reading;
}

}  // namespace unietp
