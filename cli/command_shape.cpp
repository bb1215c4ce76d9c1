#include "cli/command_shape.h"

#include <cstdio>
#include <memory>
#include <optional>

#include "cli/command_parser.h"
#include "cli/command_shape_quiz.h"
#include "core/base64.h"
#include "core/files.h"
#include "core/png.h"
#include "core/text.h"
#include "core/unknown_name.h"
#include "scene/archetype_dimensions.h"
#include "shapes/library.h"
#include "simulation/portrait.h"
#include "simulation/shape_coverage.h"

namespace unietp {
namespace {

constexpr int kPixels = 240, kColumns = 4;

struct ShapeOptions {
  std::string family, state;
  std::filesystem::path out;
  std::vector<std::filesystem::path> files;
};

std::vector<const Knowledge*> backends_of(const std::vector<Backend>& backends) {
  std::vector<const Knowledge*> all;
  for (const Backend& backend : backends) all.push_back(&backend.knowledge);
  return all;
}

/// `open`, or `filled:water`; nullopt for names of no state.
std::optional<State> state_in(const std::string& text) {
  const std::size_t colon = text.find(':');
  const auto predicate = predicate_named(text.substr(0, colon));
  if (!predicate) return std::nullopt;
  return State{*predicate, colon == std::string::npos ? "" : text.substr(colon + 1)};
}

std::vector<std::string> state_names() {
  std::vector<std::string> names;
  for (const StateGroup& group : state_groups()) {
    for (const Predicate predicate : group.predicates) names.emplace_back(info(predicate).name);
  }
  return names;
}

/// Portraits of things of a family: of the categories that it shows in turn, each picture of another variant.
std::vector<Picture> portraits_of(const ShapeFamily& family, const std::vector<Backend>& backends, std::size_t most,
                                  int pixels, const std::optional<State>& state = std::nullopt) {
  std::vector<Picture> pictures;
  const auto shown = shown_by(family, backends_of(backends));
  for (std::uint32_t seed = 0; pictures.size() < most && !shown.empty(); ++seed) {
    const ShownCategory& one = shown[seed % shown.size()];
    Node node = object_of(*one.knowledge, *one.category, seed);
    if (state) node.states.set(*state);
    if (node.states.has(Predicate::Open)) node.opening = 1;
    Profile profile;
    profile.simulator = one.knowledge->simulator();
    pictures.push_back(portrait_of(node, profile, {.pixels = pixels, .on_table = node.movable}));
  }
  return pictures;
}

std::vector<std::string> family_names() {
  std::vector<std::string> names;
  for (const ShapeFamily& family : built_in_shapes().families()) names.push_back(family.name);
  return names;
}

Exit list() {
  for (const ShapeFamily& family : built_in_shapes().families()) {
    const std::string parts = join(part_names(family), ", ");
    std::printf("%-22s %s%s\n", family.name.c_str(), family.meaning.c_str(),
                parts.empty() ? "" : (" (parts: " + parts + ")").c_str());
  }
  return Exit::Ok;
}

Exit write_png(const Picture& picture, const std::filesystem::path& path) {
  const auto bytes = png(picture.width, picture.height, picture.rgb);
  if (!bytes) return refuse(bytes.error());
  const auto written = write_file(path, *bytes);
  return written ? Exit::Ok : refuse(written.error());
}

Exit show(const ShapeOptions& options, const CommandLine& program) {
  const ShapeFamily* family = built_in_shapes().find(options.family);
  if (family == nullptr) return refuse(unknown_name_error("FAMILY", options.family, family_names()));
  const auto state = state_in(options.state);
  if (!options.state.empty() && !state) return refuse(unknown_name_error("--state", options.state, state_names()));
  const auto known = load_backends(program.folders);
  if (!known.errors.empty()) return refuse(known.errors);
  constexpr std::size_t kShown = 8;
  const auto pictures = portraits_of(*family, known.backends, kShown, kPixels, state);
  if (pictures.empty())
    return refuse({Error::Kind::Usage, "FAMILY", {}, "no category has the shape \"" + family->name + "\""});
  return write_png(sheet_of(pictures, kColumns), options.out);
}

Exit lint(const ShapeOptions& options, const CommandLine& program) {
  std::vector<Error> errors;
  if (!options.files.empty()) {
    for (const auto& path : options.files) {
      const auto text = read_file(path);
      if (!text) return refuse(text.error());
      const auto reading = parse_families(path.string(), *text);
      errors.insert(errors.end(), reading.errors.begin(), reading.errors.end());
      for (const ShapeFamily& family : reading.families) {
        const auto faults = faults_of(family, {0.2, 0.15, 0.1}, 0.005);
        errors.insert(errors.end(), faults.begin(), faults.end());
      }
    }
    if (!errors.empty()) return refuse(errors);
    std::printf("%zu %s sound\n", options.files.size(), options.files.size() == 1 ? "file is" : "files are");
    return Exit::Ok;
  }
  const auto known = load_backends(program.folders);
  if (!known.errors.empty()) return refuse(known.errors);
  const auto knowledge = backends_of(known.backends);
  for (const ShapeFamily& family : built_in_shapes().families()) {
    for (const ShownCategory& one : shown_by(family, knowledge)) {
      const auto faults = faults_of(family, one.category->size, vessel_wall(one.category->size));
      errors.insert(errors.end(), faults.begin(), faults.end());
      if (!faults.empty()) break;
    }
  }
  if (!errors.empty()) return refuse(errors);
  for (const Knowledge* one : knowledge) {
    const ShapeCoverage coverage = shape_coverage(*one);
    std::printf("%-12s %zu of %zu movable categories and %zu of %zu others have a shape; plain boxes: %zu movable\n",
                std::string(name_of(one->simulator())).c_str(), coverage.movable_shown, coverage.movable,
                coverage.others_shown, coverage.others, coverage.plain_boxes);
  }
  return Exit::Ok;
}

Exit gallery(const ShapeOptions& options, const CommandLine& program) {
  const auto known = load_backends(program.folders);
  if (!known.errors.empty()) return refuse(known.errors);
  std::string page =
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>Shapes</title><style>"
      "body{font:14px sans-serif;margin:16px}figure{display:inline-block;width:330px;margin:4px;vertical-align:top}"
      "img{width:330px}</style></head><body>\n<h1>Shapes</h1>\n";
  constexpr std::size_t kShown = 3;
  constexpr int kSmall = 110;
  for (const ShapeFamily& family : built_in_shapes().families()) {
    const auto pictures = portraits_of(family, known.backends, kShown, kSmall);
    if (pictures.empty()) continue;
    const Picture sheet = sheet_of(pictures, kShown);
    const auto bytes = png(sheet.width, sheet.height, sheet.rgb);
    if (!bytes) return refuse(bytes.error());
    page += "<figure><img alt=\"\" src=\"data:image/png;base64," + base64(*bytes) + "\"><figcaption><b>" + family.name +
            "</b> " + family.meaning + "</figcaption></figure>\n";
  }
  const auto written = write_file(options.out, page + "</body></html>\n");
  return written ? Exit::Ok : refuse(written.error());
}

}  // namespace

void add_shape_command(CommandParser& app, CommandLine& program) {
  auto options = std::make_shared<ShapeOptions>();  // shared: the callback outlives this function
  auto* group = app.add_subcommand("shape", "Show and check what categories look like");
  group->explain(
      "A shape is a family of a text file in data/shapes, and a row of categories.csv gives it to categories "
      "(docs/shapes.md).",
      {{"unietp shape list", ""},
       {"unietp shape show mug --out mug.png", ""},
       {"unietp shape lint my.shapes", ""},
       {"unietp shape gallery --out shapes.html", ""},
       {"unietp shape quiz things --seed 7 --out out/quiz", ""}});
  group->require_subcommand();
  auto* listing = group->add_subcommand("list", "List the families");
  listing->explain("Each with what it shows.", {{"unietp shape list", ""}});
  listing->callback([&program] { program.exit = list(); });
  auto* showing = group->add_subcommand("show", "Draw objects of a family");
  showing->explain("Up to eight objects: of the categories that have this shape, and in variants.",
                   {{"unietp shape show mug --out mug.png", ""},
                    {"unietp shape show kettle --state open --out open.png", ""},
                    {"unietp shape show mug --state filled:coffee --out coffee.png", ""}});
  showing->add_option("FAMILY", options->family, "Name of the family")->required()->suggests(family_names());
  showing->add_option("--state", options->state, "A state that the objects have (default: their first ones)")
      ->suggests(state_names());
  showing->add_option("--out", options->out, "PNG to write")->required()->output();
  showing->callback([options, &program] { program.exit = show(*options, program); });
  auto* linting = group->add_subcommand("lint", "Check shapes");
  linting->explain(
      "Checks files, or the built-in families with the sizes of all their categories, and then says how many "
      "categories "
      "have a shape.",
      {{"unietp shape lint", ""}, {"unietp shape lint my.shapes", ""}});
  linting->add_option("FILE", options->files, "Files of families; none: the built-in ones");
  linting->callback([options, &program] { program.exit = lint(*options, program); });
  auto* page = group->add_subcommand("gallery", "Draw all families on one page");
  page->explain("Three objects of each family, with its name and what it shows.",
                {{"unietp shape gallery --out shapes.html", ""}});
  page->add_option("--out", options->out, "HTML file to write")->required()->output();
  page->callback([options, &program] { program.exit = gallery(*options, program); });
  add_shape_quiz_command(*group, program);
}

}  // namespace unietp
