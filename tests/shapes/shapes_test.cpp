// The language of shapes, what is built of it, and which category has which.
#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include <gtest/gtest.h>

#include "core/files.h"
#include "core/rng.h"
#include "core/sexpr.h"
#include "shapes/device.h"
#include "shapes/library.h"

namespace unietp {
namespace {

const std::filesystem::path kShapes = std::filesystem::path(UNIETP_SOURCE_DIR) / "data/shapes";

std::vector<std::string> errors_in(std::string_view text) {
  std::vector<std::string> errors;
  for (const Error& error : parse_families("a.shapes", text).errors) errors.push_back(format(error));
  return errors;
}

ShapeFamily family_in(const std::string& parts) {
  const auto reading = parse_families("a.shapes", "(family one (means \"one\") " + parts + ")");
  EXPECT_TRUE(reading.errors.empty()) << (reading.errors.empty() ? "" : format(reading.errors.front()));
  return reading.families.empty() ? ShapeFamily{} : reading.families.front();
}

/// The box around the corners of blocks, and the poles of the others.
Bounds bounds_of(const std::vector<Piece>& pieces) {
  Bounds all{Vec3::Constant(9), Vec3::Constant(-9)};
  for (const Piece& piece : pieces) {
    for (int i = 0; i < 3; ++i) {
      double reach = 0;
      if (piece.kind == PieceKind::Ball) {
        reach = piece.axes.row(i).norm();
      } else if (piece.kind == PieceKind::Block || piece.kind == PieceKind::Crate) {
        for (const double end : {-1.0, 1.0}) {
          const Vec2& wide = end < 0 ? piece.low : piece.high;
          for (const double side : {-1.0, 1.0}) {
            const double at = end * piece.axes(i, 2) +
                              side * (wide.x() * std::abs(piece.axes(i, 0)) + wide.y() * std::abs(piece.axes(i, 1)));
            all.low[i] = std::min(all.low[i], piece.center[i] + at);
            all.high[i] = std::max(all.high[i], piece.center[i] + at);
          }
        }
        continue;
      } else {
        for (const double end : {-1.0, 1.0}) {
          const Vec2& wide = end < 0 ? piece.low : piece.high;
          const double aside = std::hypot(wide.x() * piece.axes(i, 0), wide.y() * piece.axes(i, 1));
          for (const double side : {-1.0, 1.0}) {
            const double at = piece.center[i] + end * piece.axes(i, 2) + side * aside;
            all.low[i] = std::min(all.low[i], at);
            all.high[i] = std::max(all.high[i], at);
          }
        }
        continue;
      }
      all.low[i] = std::min(all.low[i], piece.center[i] - reach);
      all.high[i] = std::max(all.high[i], piece.center[i] + reach);
    }
  }
  return all;
}

TEST(ShapeLanguage, SaysWhatIsWrongAndWhere) {
  EXPECT_EQ(errors_in("(family a (means \"a\")\n  (bax -1 1 -1 1 -1 1))"),
            std::vector<std::string>{"a.shapes:2:3: parse error: expected a part; did you mean \"box\"?"});
  EXPECT_EQ(errors_in("(family a (means \"a\")\n  (box -1 1 -1 1 -1))"),
            std::vector<std::string>{"a.shapes:2:3: parse error: \"box\" needs x0 x1 y0 y1 z0 z1"});
  EXPECT_EQ(errors_in("(family a (means \"a\")\n  (box -1 1 -1 1 -1 wal))").front(),
            "a.shapes:2:21: parse error: expected a number or a parameter; did you mean \"wall\"?");
  EXPECT_EQ(errors_in("(family a (means \"a\") (paint yelow (ball -1 1 -1 1 -1 1)))").front(),
            "a.shapes:1:30: parse error: expected a color, \"main\", \"dark\" or \"light\"; did you mean \"yellow\"?");
  EXPECT_EQ(errors_in("(family a (means \"a\") (param k 1 0) (ball -1 1 -1 1 -1 1))").front(),
            "a.shapes:1:23: parse error: expected (param NAME LOW HIGH) with LOW at most HIGH");
  EXPECT_EQ(errors_in("(family a (ball -1 1 -1 1 -1 1))").front(),
            "a.shapes:1:1: parse error: needs (means \"…\"): what the family shows");
  EXPECT_EQ(errors_in("(fmaily a)").front(), "a.shapes:1:1: parse error: expected (family NAME …)");
  EXPECT_EQ(errors_in("(family a (means \"a\") (when opne (ball -1 1 -1 1 -1 1)))").front(),
            "a.shapes:1:23: parse error: expected a state such as \"open\" after \"when\"");
}

TEST(ShapeLanguage, StretchesTheWholeToTheObjectsBox) {
  const ShapeFamily family =
      family_in("(box -0.8 0.9 -1 1 -1 1) (rod 0 0 0 1 1 1 0.2) (arc 0 0 0 0.9 1.1 0 200 6 0.1)");
  for (const Vec3& size : {Vec3(0.1, 0.2, 0.3), Vec3(2, 0.05, 1)}) {
    const Bounds all = bounds_of(pieces_of(family, {size, 0.004, 3, {}}));
    EXPECT_LT((all.low + Vec3::Ones()).norm(), 1e-9);
    EXPECT_LT((all.high - Vec3::Ones()).norm(), 1e-9);
  }
}

TEST(ShapeLanguage, VariesBySeedAndRepeatsWithIt) {
  const ShapeFamily family =
      family_in("(param a 0.2 0.9) (drum -1 1 -1 1 -1 1 (high a)) (paint (any red blue) (ball 0 1 0 1 0 1))");
  const auto with = [&](std::uint32_t seed) { return pieces_of(family, {{0.1, 0.1, 0.2}, 0.004, seed, {}}); };
  std::set<double> ends;
  std::set<Rgb> colors;
  for (std::uint32_t seed = 0; seed < 30; ++seed) {
    ends.insert(with(seed)[0].high.x());
    colors.insert(*with(seed)[1].color);
    EXPECT_EQ(with(seed)[0].high.x(), with(seed)[0].high.x());
  }
  EXPECT_EQ(ends.size(), 30U);
  EXPECT_EQ(colors.size(), 2U);
  EXPECT_GE(*ends.begin(), 0.2);
  EXPECT_LT(*ends.rbegin(), 0.9);
}

TEST(ShapeLanguage, PutsAxesAndStatesWhereTheySay) {
  // The longest side of the object is y, the shortest x.
  const Vec3 size(0.1, 0.4, 0.2);
  const auto tip =
      pieces_of(family_in("(axes long) (box -1 1 -1 1 -1 1) (ball 0.5 1 -0.2 0.2 -0.2 0.2)"), {size, 0.004, 1, {}});
  EXPECT_NEAR(tip[1].center.y(), 0.75, 1e-9);
  const auto lies =
      pieces_of(family_in("(axes tall) (box -1 1 -1 1 -1 1) (ball -0.2 0.2 -0.2 0.2 0.5 1)"), {size, 0.004, 1, {}});
  EXPECT_NEAR(lies[1].center.y(), 0.75, 1e-9);
  const ShapeFamily lid = family_in("(box -1 1 -1 1 -1 1) (when open (ball -1 1 -1 1 -1 1) (ball -1 0 -1 0 -1 0))");
  StateSet open;
  open.set({Predicate::Open, ""});
  EXPECT_EQ(pieces_of(lid, {size, 0.004, 1, {}}).size(), 1U);
  EXPECT_EQ(pieces_of(lid, {size, 0.004, 1, open}).size(), 3U);
}

TEST(ShapeLanguage, TurnsAndMovesPartsWhenOpenAndKeepsTheRest) {
  // The lid turns rigidly, in meters: it is 0.2 m deep and then 0.2 m high.
  const Vec3 size(0.1, 0.2, 0.4);
  const ShapeFamily family = family_in(
      "(box -1 1 -1 1 -1 0.8) (hinge x -90 0 1 0.8 (box -1 1 -1 1 0.8 1)) (slide 0 -1 0 (box -0.5 0.5 -1 1 -0.5 0))");
  StateSet open;
  open.set({Predicate::Open, ""});
  const auto closed = pieces_of(family, {size, 0.004, 1, {}}), opened = pieces_of(family, {size, 0.004, 1, open});
  ASSERT_EQ(closed.size(), 3U);
  ASSERT_EQ(opened.size(), 3U);
  EXPECT_LT((opened[0].axes - closed[0].axes).norm(), 1e-9) << "the body is not stretched";
  EXPECT_LT((opened[0].center - closed[0].center).norm(), 1e-9);
  EXPECT_NEAR(opened[1].center.y(), 1 + 0.02 / 0.1, 1e-6) << "behind the hinge, as far as it was above it";
  EXPECT_NEAR(opened[1].center.z(), 0.8 + 0.1 / 0.2, 1e-6) << "as far above it as it was before it";
  EXPECT_NEAR(opened[2].center.y() - closed[2].center.y(), -1, 1e-9);
}

TEST(ShapeLanguage, NamesOfPartsAreListedAndChangeNothing) {
  const ShapeFamily named =
      family_in("(part body (box -1 1 -1 1 -1 0.8)) (mirror x (part handle (ball 0.5 1 -1 1 0 1)))");
  EXPECT_EQ(part_names(named), (std::vector<std::string>{"body", "handle"}));
  const ShapeFamily plain = family_in("(box -1 1 -1 1 -1 0.8) (mirror x (ball 0.5 1 -1 1 0 1))");
  const auto with = pieces_of(named, {{0.1, 0.1, 0.2}, 0.004, 1, {}}),
             without = pieces_of(plain, {{0.1, 0.1, 0.2}, 0.004, 1, {}});
  ASSERT_EQ(with.size(), without.size());
  for (std::size_t i = 0; i < with.size(); ++i) EXPECT_EQ(with[i].axes, without[i].axes);
  EXPECT_EQ(errors_in("(family a (means \"a\") (part (ball -1 1 -1 1 -1 1)))").front(),
            "a.shapes:1:23: parse error: expected a name after \"part\"");
}

TEST(ShapeLanguage, CapsulesAreAsRoundAsTheBoxAllows) {
  const auto pieces = pieces_of(family_in("(capsule -1 1 -1 1 -1 1)"), {{0.1, 0.1, 0.4}, 0.004, 1, {}});
  ASSERT_EQ(pieces.size(), 3U);
  EXPECT_EQ(pieces[0].kind, PieceKind::Drum);
  EXPECT_EQ(pieces[1].kind, PieceKind::Ball);
  EXPECT_NEAR(pieces[1].axes(2, 2), 0.25, 1e-4) << "0.05 m of half a height of 0.2 m";
  EXPECT_NEAR(pieces[2].center.z(), 0.75, 1e-4);
  const auto ball = pieces_of(family_in("(capsule -1 1 -1 1 -1 1)"), {{0.4, 0.4, 0.1}, 0.004, 1, {}});
  EXPECT_EQ(ball.size(), 1U);
}

TEST(ShapeLanguage, LintFindsPartsWithoutVolumeAndShapesThatDoNotFit) {
  const auto faults = [](const std::string& parts) {
    return faults_of(family_in(parts), {0.1, 0.1, 0.1}, 0.004).size();
  };
  EXPECT_EQ(faults("(box -1 1 -1 1 -1 1)"), 0U);
  EXPECT_EQ(faults("(box -1 1 -1 1 -1 1) (box 0 1 0 0 0 1)"), 1U);
  EXPECT_EQ(faults("(box -1 1 -1 1 -1 1 (high 1.4))"), 1U);
  EXPECT_EQ(faults("(box -0.2 0.2 -1 1 -1 1)"), 1U);
  EXPECT_EQ(faults("(box -1 1 -1 1 -1 1) (when open (box 0 1 0 0 0 1))"), 1U);
}

TEST(ShapeLibrary, FindsFamiliesByWholeNameBeginningEndAndArchetype) {
  const std::string families =
      "(family mug (means \"m\") (ball -1 1 -1 1 -1 1))(family sack (means \"s\") (ball -1 1 -1 1 -1 1))"
      "(family pot (means \"p\") (ball -1 1 -1 1 -1 1))";
  const auto reading = read_shape_library(
      {{"a.shapes", families}}, {"categories.csv",
                                 "match,name,family\nends,mug,mug\nbegins,bag "
                                 "of,sack\narchetype,vessel,pot\nai2thor,TravelMug,pot\nends,bag of mug,mug\n"});
  ASSERT_TRUE(reading.errors.empty()) << format(reading.errors.front());
  const auto name = [&](const char* category, Archetype archetype = Archetype::Box) {
    const ShapeFamily* family = reading.library.family_of(Simulator::Ai2thor, category, archetype);
    return family == nullptr ? std::string() : family->name;
  };
  EXPECT_EQ(name("CoffeeMug"), "mug");
  EXPECT_EQ(name("coffee_mug"), "mug");
  EXPECT_EQ(name("smug"), "");
  EXPECT_EQ(name("bag_of_rice"), "sack");
  EXPECT_EQ(name("bag_of_mug"), "mug");
  EXPECT_EQ(name("TravelMug"), "pot");
  EXPECT_EQ(name("urn", Archetype::Vessel), "pot");
  EXPECT_EQ(name("urn"), "");
}

TEST(ShapeLibrary, RefusesRowsThatNameNothing) {
  const auto reading =
      read_shape_library({{"a.shapes", "(family mug (means \"m\") (ball -1 1 -1 1 -1 1))"}},
                         {"categories.csv", "match,name,family\nends,mug,mgu\nstarts,mug,mug\nends,mug,mug\n"});
  ASSERT_EQ(reading.errors.size(), 3U);
  EXPECT_EQ(format(reading.errors[0]), "categories.csv:2:10: schema error: there is no family \"mgu\"");
  EXPECT_EQ(reading.errors[1].pos, (SourcePos{3, 1}));
  EXPECT_EQ(format(reading.errors[2]), "categories.csv:4:6: schema error: \"mug\" has a row already");
}

TEST(Devices, AreThoseOfTheFirstRowThatFits) {
  const DeviceTable table = read_devices("devices.csv", "part,device\nlightswitch,appliance\nlight,lamp\ntv,screen\n");
  ASSERT_TRUE(table.errors.empty()) << format(table.errors.front());
  EXPECT_EQ(device_of(table.rows, "LightSwitch"), Device::Appliance);
  EXPECT_EQ(device_of(table.rows, "ceiling_light"), Device::Lamp);
  EXPECT_EQ(device_of(table.rows, "t_v"), Device::Screen);
  EXPECT_EQ(device_of(table.rows, "toaster"), Device::Appliance);
}

TEST(Devices, RefuseRowsThatAreUnknownOrNeverUsed) {
  const DeviceTable table =
      read_devices("devices.csv", "part,device\nlight,lamp\nLamp,lamp\ntap,water\nheadlight,lamp\n");
  ASSERT_EQ(table.errors.size(), 3U);
  EXPECT_EQ(format(table.errors[0]), "devices.csv:3:1: schema error: expected lower case without \"_\"");
  EXPECT_EQ(table.errors[1].pos, (SourcePos{4, 5}));
  EXPECT_EQ(format(table.errors[2]),
            "devices.csv:5:1: schema error: is never used: the row of \"light\" above decides for it");
}

TEST(Devices, OfTheProgramAreThoseOfItsFile) {
  const DeviceTable table = read_devices("devices.csv", *read_file(kShapes / "devices.csv"));
  for (const Error& error : table.errors) ADD_FAILURE() << format(error);
  EXPECT_EQ(built_in_devices(), table.rows);
  EXPECT_EQ(device_of(built_in_devices(), "StoveBurner"), Device::Burner);
}

/// A family's tree of parts without its numbers, colors and words.
std::string tree_of(const ShapePart& part) {
  std::string tree = "(" + std::to_string(static_cast<int>(part.kind)) + part.axis;
  for (const ShapePart& one : part.parts) tree += tree_of(one);
  return tree + ")";
}

TEST(BuiltInShapes, AreSoundAndTheFilesOfTheData) {
  const auto reading = load_shape_library(kShapes);
  for (const Error& error : reading.errors) ADD_FAILURE() << format(error);
  const auto& built_in = built_in_shapes().families();
  ASSERT_EQ(built_in.size(), reading.library.families().size());
  for (const ShapeFamily& family : reading.library.families()) EXPECT_NE(built_in_shapes().find(family.name), nullptr);
  EXPECT_GE(built_in.size(), 250U);
  std::set<std::string> trees;
  for (const ShapeFamily& family : built_in) {
    std::string tree;
    for (const ShapePart& part : family.parts) tree += tree_of(part);
    trees.insert(tree);
  }
  EXPECT_GE(trees.size(), 250U);  // different trees of parts
}

TEST(BuiltInShapes, DifferByEachOfTheirParameters) {
  StateSet open;
  open.set({Predicate::Open, ""});
  const auto with = [&](ShapeFamily family, std::size_t parameter, double value) {
    family.parameters[parameter].low = family.parameters[parameter].high = value;
    auto pieces = pieces_of(family, {{0.5, 0.4, 0.6}, 0.004, 1, {}});
    const auto opened = pieces_of(family, {{0.5, 0.4, 0.6}, 0.004, 1, open});
    pieces.insert(pieces.end(), opened.begin(), opened.end());
    return pieces;
  };
  const auto differ = [](const Piece& a, const Piece& b) {
    return a.center != b.center || a.axes != b.axes || a.low != b.low || a.high != b.high || a.wall != b.wall ||
           a.floor != b.floor;
  };
  for (const ShapeFamily& family : built_in_shapes().families()) {
    for (std::size_t i = 0; i < family.parameters.size(); ++i) {
      const auto& parameter = family.parameters[i];
      const auto least = with(family, i, parameter.low), most = with(family, i, parameter.high);
      EXPECT_FALSE(std::equal(least.begin(), least.end(), most.begin(), most.end(), std::not_fn(differ)))
          << family.name << " has the same pieces whatever " << parameter.name << " is";
    }
  }
}

}  // namespace
}  // namespace unietp
