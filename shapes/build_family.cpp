#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/limits.h"
#include "core/rng.h"
#include "shapes/family.h"
#include "shapes/known_values.h"

namespace unietp {
namespace {

using Kind = ShapePart::Kind;
using Matrix = Eigen::Matrix3d;

constexpr double kSlack = 1e-6;         // of the box's half extents, for rounding
constexpr double kLeastVolume = 1e-12;  // of a piece, as a determinant

/// A map of the family's box into itself.
struct Frame {
  Matrix turn = Matrix::Identity();
  Vec3 move = Vec3::Zero();
  Vec3 operator()(const Vec3& at) const { return turn * at + move; }
  Frame then_inside(const Matrix& inner, const Vec3& moved) const { return {turn * inner, turn * moved + move}; }
};

struct Coat {
  std::optional<Rgb> color{};
  double shade = 1;
  std::optional<Matter> matter{};
};

/// Sine and cosine of an angle in degrees.
std::pair<double, double> turned(double degrees) {
  const double angle = degrees * std::numbers::pi / 180;
  return {std::sin(angle), std::cos(angle)};
}

Matrix rotation(char axis, double degrees) {
  const auto [sine, cosine] = turned(degrees);
  Matrix turn = Matrix::Identity();
  const int a = axis == 'x' ? 1 : 0, b = axis == 'z' ? 1 : 2;
  turn(a, a) = turn(b, b) = cosine;
  turn(a, b) = axis == 'y' ? sine : -sine;
  turn(b, a) = -turn(a, b);
  return turn;
}

class Builder {
 public:
  /// `order`: of the axes of the object's box, that of each axis of the family.
  Builder(const ShapeFamily& family, const ShapeObject& object, const std::array<int, 3>& order)
      : order_(order), states_(object.states) {
    for (int i = 0; i < 3; ++i) half_m_[i] = object.size[order[static_cast<std::size_t>(i)]] / 2;
    wall_m_ = object.wall_m;
    values_ = {2 * half_m_.x(), 2 * half_m_.y(), 2 * half_m_.z(), wall_m_};
    Rng rng(object.seed);
    for (const auto& parameter : family.parameters) values_.push_back(rng.uniform(parameter.low, parameter.high));
    choice_ = rng.next();
  }

  void add(const std::vector<ShapePart>& parts, const Frame& frame, const Coat& coat) {
    for (const ShapePart& part : parts) add(part, frame, coat);
  }

  std::vector<Piece> pieces;
  std::vector<const ShapePart*> sources;  // the part of each piece

 private:
  double value(const ShapeNumber& number) const {
    using Of = ShapeNumber::Kind;
    if (number.kind == Of::Constant) return number.constant;
    if (number.kind == Of::Parameter) return values_[number.parameter];
    double sum = value(number.parts.front());
    for (std::size_t i = 1; i < number.parts.size(); ++i) {
      const double next = value(number.parts[i]);
      switch (number.kind) {
        case Of::Sum:
          sum += next;
          break;
        case Of::Difference:
          sum -= next;
          break;
        case Of::Product:
          sum *= next;
          break;
        default:
          sum /= next;
          break;
      }
    }
    return sum;
  }
  std::vector<double> values(const std::vector<ShapeNumber>& numbers) const {
    std::vector<double> all;
    all.reserve(numbers.size());
    for (const ShapeNumber& number : numbers) all.push_back(value(number));
    return all;
  }
  Vec2 pair(const std::vector<ShapeNumber>& numbers, const Vec2& otherwise) const {
    if (numbers.empty()) return otherwise;
    return {value(numbers.front()), value(numbers.back())};
  }
  static int times(double number) {
    return std::isfinite(number) ? static_cast<int>(std::clamp(number, 0.0, 1.0 * limits::kShapePieces)) : 0;
  }

  void add(const ShapePart& part, const Frame& frame, const Coat& coat) {
    if (pieces.size() >= limits::kShapePieces) return;
    const auto numbers = values(part.numbers);
    switch (part.kind) {
      case Kind::Block:
      case Kind::Drum:
      case Kind::Ball:
      case Kind::Cup:
      case Kind::Crate:
        return solid(part, numbers, frame, coat);
      case Kind::Capsule:
        return capsule(part, numbers, frame, coat);
      case Kind::Lathe:
        return lathe(part, numbers, frame, coat);
      case Kind::Rod:
        return rod(part, {numbers[0], numbers[1], numbers[2]}, {numbers[3], numbers[4], numbers[5]}, numbers[6],
                   numbers.back(), frame, coat);
      case Kind::Arc:
        return arc(part, numbers, frame, coat);
      case Kind::Extrusion:
        return extrusion(part, numbers, frame, coat);
      case Kind::Repeat: {
        const Vec3 step(numbers[1], numbers[2], numbers[3]);
        for (int i = 0; i < times(numbers[0]); ++i)
          add(part.parts, frame.then_inside(Matrix::Identity(), i * step), coat);
        return;
      }
      case Kind::Ring: {
        const int count = times(numbers[0]);
        for (int i = 0; i < count; ++i)
          add(part.parts, frame.then_inside(rotation(part.axis, 360.0 * i / count), Vec3::Zero()), coat);
        return;
      }
      case Kind::Mirror: {
        Matrix flip = Matrix::Identity();
        flip(part.axis - 'x', part.axis - 'x') = -1;
        add(part.parts, frame, coat);
        return add(part.parts, frame.then_inside(flip, Vec3::Zero()), coat);
      }
      case Kind::Turn: {
        const Matrix turn = rotation(part.axis, numbers[0]);
        const Vec3 about(numbers[1], numbers[2], numbers[3]);
        return add(part.parts, frame.then_inside(turn, about - turn * about), coat);
      }
      case Kind::Hinge: {
        if (!states_.has(Predicate::Open)) return add(part.parts, frame, coat);
        const auto in_box = half_m_.cwiseInverse().asDiagonal();
        const Matrix turn = in_box * rotation(part.axis, numbers[0]) * half_m_.asDiagonal();
        const Vec3 about(numbers[1], numbers[2], numbers[3]);
        return add(part.parts, frame.then_inside(turn, about - turn * about), coat);
      }
      case Kind::Slide: {
        const Vec3 by = states_.has(Predicate::Open) ? Vec3(numbers[0], numbers[1], numbers[2]) : Vec3(Vec3::Zero());
        return add(part.parts, frame.then_inside(Matrix::Identity(), by), coat);
      }
      case Kind::Named:
        return add(part.parts, frame, coat);
      case Kind::Paint:
        return add(part.parts, frame, painted(part, coat));
      case Kind::When:
      case Kind::Unless:
        if (states_.has(part.state) == (part.kind == Kind::When)) add(part.parts, frame, coat);
        return;
    }
  }

  Coat painted(const ShapePart& part, const Coat& before) const {
    Coat coat = before;
    const std::string& name = part.colors[choice_ % part.colors.size()];
    if (const Rgb* rgb = color_named(name)) {
      coat.color = *rgb;
    } else {
      coat.color.reset();
      coat.shade = name == "dark" ? 0.58 : name == "light" ? 1.3 : 1.0;
    }
    if (!part.material.empty()) coat.matter = material_named(part.material)->matter;
    return coat;
  }

  /// Adds a piece whose own frame has these axes and center in the family's box.
  void put(const ShapePart& part, PieceKind kind, const Matrix& axes, const Vec3& center, const Vec2& low,
           const Vec2& high, const Frame& frame, const Coat& coat) {
    if (pieces.size() >= limits::kShapePieces) return;
    Piece piece;
    piece.kind = kind;
    const Matrix own = frame.turn * axes;
    const Vec3 at = frame(center);
    for (int i = 0; i < 3; ++i) {
      piece.axes.row(order_[static_cast<std::size_t>(i)]) = own.row(i);
      piece.center[order_[static_cast<std::size_t>(i)]] = at[i];
    }
    piece.low = low;
    piece.high = high;
    piece.color = coat.color;
    piece.shade = coat.shade;
    piece.matter = coat.matter;
    piece.screen = part.screen;
    if (kind == PieceKind::Cup || kind == PieceKind::Crate) hollow(part, axes, piece);
    pieces.push_back(piece);
    sources.push_back(&part);
  }

  /// Wall and floor as given, or as thick as physics has them.
  void hollow(const ShapePart& part, const Matrix& axes, Piece& piece) const {
    const auto across = [&](int i) { return axes.col(i).cwiseProduct(half_m_).norm(); };
    const double wall = part.wall.empty() ? wall_m_ / std::min(across(0), across(1)) : value(part.wall.front());
    const double floor = part.floor.empty() ? wall_m_ / across(2) : value(part.floor.front());
    constexpr double kLeast = 1e-3, kMost = 0.9;
    piece.wall = std::clamp(wall, kLeast, kMost * std::min(piece.low.minCoeff(), piece.high.minCoeff()));
    piece.floor = std::clamp(floor, kLeast, 2 * kMost);
  }

  void solid(const ShapePart& part, const std::vector<double>& n, const Frame& frame, const Coat& coat) {
    const Vec3 low(n[0], n[2], n[4]), high(n[1], n[3], n[5]);
    const Vec3 half = (high - low) / 2, center = (high + low) / 2;
    const int stands = part.axis - 'x', first = part.axis == 'x' ? 1 : 0, second = part.axis == 'z' ? 1 : 2;
    Matrix axes = Matrix::Zero();
    axes(first, 0) = half[first];
    axes(second, 1) = half[second];
    axes(stands, 2) = half[stands];
    if (!part.shift.empty()) {  // of the upper end, half of it for each end
      axes(first, 2) = value(part.shift[0]) / 2;
      axes(second, 2) = value(part.shift[1]) / 2;
    }
    const Vec2 below = pair(part.low, Vec2::Ones()), above = pair(part.high, Vec2::Ones());
    const PieceKind kind = part.kind == Kind::Block  ? PieceKind::Block
                           : part.kind == Kind::Drum ? PieceKind::Drum
                           : part.kind == Kind::Ball ? PieceKind::Ball
                           : part.kind == Kind::Cup  ? PieceKind::Cup
                                                     : PieceKind::Crate;
    put(part, kind, axes, center, below, above, frame, coat);
  }

  /// A cylinder between two half balls, which are as round in meters as the ends of the box allow.
  void capsule(const ShapePart& part, const std::vector<double>& n, const Frame& frame, const Coat& coat) {
    const int stands = part.axis - 'x', first = part.axis == 'x' ? 1 : 0, second = part.axis == 'z' ? 1 : 2;
    const Vec3 half = (Vec3(n[1], n[3], n[5]) - Vec3(n[0], n[2], n[4])) / 2;
    const Vec3 center = (Vec3(n[1], n[3], n[5]) + Vec3(n[0], n[2], n[4])) / 2, half_m = half.cwiseProduct(half_m_);
    const double cap = half[stands] * std::min(1.0, std::min(half_m[first], half_m[second]) / half_m[stands]);
    const double straight = half[stands] - cap;
    const auto add_at = [&](PieceKind kind, double along, double long_half) {
      Matrix axes = Matrix::Zero();
      axes(first, 0) = half[first];
      axes(second, 1) = half[second];
      axes(stands, 2) = long_half;
      put(part, kind, axes, center + along * Vec3::Unit(stands), Vec2::Ones(), Vec2::Ones(), frame, coat);
    };
    if (straight > kSlack) add_at(PieceKind::Drum, 0, straight);
    add_at(PieceKind::Ball, -straight, cap);
    if (straight > kSlack) add_at(PieceKind::Ball, straight, cap);
  }

  void lathe(const ShapePart& part, const std::vector<double>& n, const Frame& frame, const Coat& coat) {
    const int stands = part.axis - 'x', first = part.axis == 'x' ? 1 : 0, second = part.axis == 'z' ? 1 : 2;
    const Vec2 at = pair(part.shift, Vec2::Zero());
    for (std::size_t i = 0; i + 3 < n.size(); i += 2) {
      const double wide = std::max(n[i + 1], n[i + 3]);
      if (!(wide > 0) || n[i] == n[i + 2]) continue;
      Matrix axes = Matrix::Zero();
      axes(first, 0) = axes(second, 1) = wide;
      axes(stands, 2) = (n[i + 2] - n[i]) / 2;
      Vec3 center = Vec3::Zero();
      center[first] = at.x();
      center[second] = at.y();
      center[stands] = (n[i] + n[i + 2]) / 2;
      put(part, PieceKind::Drum, axes, center, Vec2::Constant(n[i + 1] / wide), Vec2::Constant(n[i + 3] / wide), frame,
          coat);
    }
  }

  /// Round in meters, whatever the proportions of the box; radii in half extents of its shortest side.
  void rod(const ShapePart& part, const Vec3& from, const Vec3& to, double radius, double end_radius,
           const Frame& frame, const Coat& coat) {
    const Vec3 way = (to - from).cwiseProduct(half_m_);
    const double wide = std::max(radius, end_radius), length = way.norm();
    if (!(length > 0) || !(wide > 0)) return;
    const Vec3 along = way / length;
    int least = 0;
    along.cwiseAbs().minCoeff(&least);
    const Vec3 aside = along.cross(Vec3::Unit(least)).normalized(), third = along.cross(aside);
    const double radius_m = wide * half_m_.minCoeff();
    Matrix axes;
    axes.col(0) = (radius_m * aside).cwiseQuotient(half_m_);
    axes.col(1) = (radius_m * third).cwiseQuotient(half_m_);
    axes.col(2) = (to - from) / 2;
    put(part, PieceKind::Drum, axes, (from + to) / 2, Vec2::Constant(radius / wide), Vec2::Constant(end_radius / wide),
        frame, coat);
  }

  /// A bent rod: a chain of straight ones along an ellipse around the part's axis.
  void arc(const ShapePart& part, const std::vector<double>& n, const Frame& frame, const Coat& coat) {
    const int first = part.axis == 'x' ? 1 : 0, second = part.axis == 'z' ? 1 : 2, steps = times(n[7]);
    const auto at = [&](int i) {
      const auto [sine, cosine] = turned(n[5] + (n[6] - n[5]) * i / steps);
      Vec3 point(n[0], n[1], n[2]);
      point[first] += n[3] * cosine;
      point[second] += n[4] * sine;
      return point;
    };
    for (int i = 0; i < steps; ++i) rod(part, at(i), at(i + 1), n[8], n[8], frame, coat);
  }

  /// A convex polygon drawn out along the part's axis, as triangles around its first corner.
  void extrusion(const ShapePart& part, const std::vector<double>& n, const Frame& frame, const Coat& coat) {
    const int stands = part.axis - 'x', first = part.axis == 'x' ? 1 : 0, second = part.axis == 'z' ? 1 : 2;
    const auto corner = [&](std::size_t i) {
      Vec3 point = Vec3::Zero();
      point[first] = n[2 + 2 * i];
      point[second] = n[3 + 2 * i];
      point[stands] = (n[0] + n[1]) / 2;
      return point;
    };
    for (std::size_t i = 1; 2 * i + 5 < n.size(); ++i) {
      const Vec3 a = corner(i), b = corner(i + 1), apex = corner(0), middle = (a + b) / 2;
      Matrix axes = Matrix::Zero();
      axes.col(0) = (b - a) / 2;
      axes(stands, 1) = (n[1] - n[0]) / 2;
      axes.col(2) = (apex - middle) / 2;
      put(part, PieceKind::Block, axes, (apex + middle) / 2, Vec2::Ones(), Vec2(0, 1), frame, coat);
    }
  }

  std::array<int, 3> order_;
  const StateSet& states_;
  Vec3 half_m_ = Vec3::Ones();
  double wall_m_ = 0.01;
  std::vector<double> values_;
  std::uint64_t choice_ = 0;
};

std::array<int, 3> order_of(ShapeAxes axes, const Vec3& size) {
  constexpr double kLies = 1.35;  // times its height
  if (axes == ShapeAxes::Upright) return {0, 1, 2};
  if (axes == ShapeAxes::Tall) {
    if (size.head<2>().maxCoeff() < kLies * size.z()) return {0, 1, 2};
    return size.x() >= size.y() ? std::array{1, 2, 0} : std::array{0, 2, 1};
  }
  if (axes == ShapeAxes::Wide) return size.x() >= size.y() ? std::array{0, 1, 2} : std::array{1, 0, 2};
  std::array<int, 3> order{0, 1, 2};
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return size[a] > size[b]; });
  return order;
}

/// The bounds of a piece in the object's box.
Bounds bounds_of(const Piece& piece) {
  Vec3 reach;
  if (piece.kind == PieceKind::Ball) {
    for (int i = 0; i < 3; ++i) reach[i] = piece.axes.row(i).norm();
    return {piece.center - reach, piece.center + reach};
  }
  const bool round = piece.kind == PieceKind::Drum || piece.kind == PieceKind::Cup;
  Bounds bounds{piece.center, piece.center};
  for (const double end : {-1.0, 1.0}) {
    const Vec2& wide = end < 0 ? piece.low : piece.high;
    for (int i = 0; i < 3; ++i) {
      const double a = wide.x() * std::abs(piece.axes(i, 0)), b = wide.y() * std::abs(piece.axes(i, 1));
      const double aside = round ? std::sqrt(a * a + b * b) : a + b;
      const double middle = piece.center[i] + end * piece.axes(i, 2);
      bounds.low[i] = std::min(bounds.low[i], middle - aside);
      bounds.high[i] = std::max(bounds.high[i], middle + aside);
    }
  }
  return bounds;
}

bool has_volume(const Piece& piece) {
  const double volume = std::abs(piece.axes.determinant());
  return std::isfinite(volume) && volume > kLeastVolume && piece.center.allFinite() && piece.low.allFinite() &&
         piece.high.allFinite() && piece.low.minCoeff() >= 0 && piece.high.minCoeff() >= 0 &&
         std::max(piece.low.maxCoeff(), piece.high.maxCoeff()) <= 1 + kSlack &&
         piece.low.maxCoeff() + piece.high.maxCoeff() > 0;
}

Bounds bounds_of(const std::vector<Piece>& pieces) {
  Bounds all{Vec3::Constant(1e9), Vec3::Constant(-1e9)};
  for (const Piece& piece : pieces) {
    const Bounds one = bounds_of(piece);
    all = {all.low.cwiseMin(one.low), all.high.cwiseMax(one.high)};
  }
  return all;
}

/// Makes the later of two pieces with a common face a little smaller, so that the first is seen.
void set_back(std::vector<Piece>& pieces, bool around_body) {
  constexpr double kBack = 1e-5, kBefore = 1e-4;  // shares of its half axes
  double share = around_body ? 1 + kBefore : 1;
  for (Piece& piece : pieces) {
    piece.axes *= share;
    share -= around_body ? 0 : kBack;
  }
}

/// Stretches all pieces so that what has these bounds fills the object's box.
void fit(std::vector<Piece>& pieces, const Bounds& all) {
  for (int i = 0; i < 3; ++i) {
    const double middle = (all.low[i] + all.high[i]) / 2, reach = (all.high[i] - all.low[i]) / 2;
    if (std::abs(middle) < kSlack && std::abs(reach - 1) < kSlack) continue;
    for (Piece& piece : pieces) {
      piece.center[i] = (piece.center[i] - middle) / reach;
      piece.axes.row(i) /= reach;
    }
  }
}

/// Of a family, before it is fitted.
std::vector<Piece> loose_pieces(const ShapeFamily& family, const ShapeObject& object) {
  Builder builder(family, object, order_of(family.axes, object.size));
  builder.add(family.parts, {}, {});
  std::erase_if(builder.pieces, [](const Piece& piece) { return !has_volume(piece); });
  return std::move(builder.pieces);
}

}  // namespace

std::vector<Piece> pieces_of(const ShapeFamily& family, const ShapeObject& object) {
  std::vector<Piece> pieces = loose_pieces(family, object);
  set_back(pieces, family.keeps_body);
  if (family.keeps_body || pieces.empty()) return pieces;
  if (family.opens && object.states.has(Predicate::Open)) {
    ShapeObject closed = object;
    closed.states.clear(Predicate::Open);
    fit(pieces, bounds_of(loose_pieces(family, closed)));
  } else {
    fit(pieces, bounds_of(pieces));
  }
  return pieces;
}

const std::string* usual_color(const ShapeFamily& family, std::uint32_t seed) {
  if (family.colors.empty()) return nullptr;
  return &family.colors[Rng(seed).fork("colour", 0).below(family.colors.size())];
}

std::vector<Error> faults_of(const ShapeFamily& family, const Vec3& size, double wall_m) {
  constexpr std::uint32_t kSeeds = 40;
  constexpr double kLeast = 0.4, kMost = 2;  // of what is then stretched to 1
  std::vector<Error> faults;
  const auto fail = [&](const SourcePos& pos, std::string message) {
    Error error{Error::Kind::Schema, family.file, pos, family.name + ": " + std::move(message)};
    if (std::find(faults.begin(), faults.end(), error) == faults.end()) faults.push_back(std::move(error));
  };
  for (std::uint32_t i = 0; i < (family.shows_open ? 2 : 1) * kSeeds; ++i) {
    const bool open = i >= kSeeds;
    ShapeObject object{size, wall_m, i % kSeeds, {}};
    if (open) object.states.set({Predicate::Open, ""});
    Builder builder(family, object, order_of(family.axes, size));
    builder.add(family.parts, {}, {});
    if (builder.pieces.size() >= limits::kShapePieces)
      fail(family.pos, "has " + std::to_string(limits::kShapePieces) + " pieces or more");
    for (std::size_t k = 0; k < builder.pieces.size(); ++k) {
      if (!has_volume(builder.pieces[k]))
        fail(builder.sources[k]->pos, "the part has no volume, or an end wider than itself");
    }
    const Bounds all = bounds_of(builder.pieces);
    const auto reaches = [&](int axis) {
      return -all.low[axis] > kLeast && -all.low[axis] < kMost && all.high[axis] > kLeast && all.high[axis] < kMost;
    };
    if (!family.keeps_body && !(open && family.opens) && !(reaches(0) && reaches(1) && reaches(2)))
      fail(family.pos, "is much smaller or larger than the object's box (from -1 to 1 on each axis)");
  }
  return faults;
}

}  // namespace unietp
