#include "cli/command_shape_quiz.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>

#include "core/files.h"
#include "core/png.h"
#include "homes/scene_folder.h"
#include "simulation/portrait_quiz.h"

namespace unietp {
namespace {

constexpr int kQuizPixels = 256, kQuizColumns = 6, kQuizRows = 4;
constexpr std::array<std::uint8_t, 3> kQuizFrame{255, 255, 255};

struct QuizOptions {
  std::string of = "things";
  std::filesystem::path out;
  std::size_t count = 96, movables = 200, furniture = 100;
  std::uint64_t seed = 1;
};

/// What a quiz can ask.
struct QuizKind {
  std::string_view name;
  const char* how_many;  // the option that says it
  std::vector<QuizItem> (*items)(const std::vector<const Knowledge*>&, const QuizOptions&);
};
constexpr std::array kQuizKinds{
    QuizKind{"things", "--movables",
             [](const auto& knowledge, const QuizOptions& options) {
               return quiz_of_things(knowledge, options.movables, options.furniture, options.seed);
             }},
    QuizKind{"states", "--count",
             [](const auto& knowledge, const QuizOptions& options) {
               return quiz_of_states(knowledge, options.count, options.seed);
             }},
    QuizKind{"materials", "--count",
             [](const auto& knowledge, const QuizOptions& options) {
               return quiz_of_materials(knowledge, options.count, options.seed);
             }},
};

std::vector<Picture> pictures_of(const QuizItem& item) {
  std::vector<Picture> pictures;
  Profile profile;
  profile.simulator = item.knowledge->simulator();
  PortraitOptions view = item.view;
  view.pixels = kQuizPixels;
  for (const Node& node : item.shown) {
    pictures.push_back(portrait_of(node, profile, view));
    draw_box(pictures.back(), {0, 0, kQuizPixels - 1, kQuizPixels - 1}, kQuizFrame);
  }
  return pictures;
}

std::string centimeters(const Vec3& size) {
  std::string text;
  for (const double side : size) text += (text.empty() ? "" : "x") + std::to_string(std::lround(100 * side));
  return text;
}

/// sheet-01.png and so on, questions.csv, and the answers apart in answers.csv.
Exit write_quiz(const std::vector<QuizItem>& items, const std::filesystem::path& out) {
  std::string questions = "number,sheet,row,column,size_cm,question\n", answers = "number,simulator,category,answer\n";
  std::vector<Picture> pictures;
  std::size_t sheets = 0;
  const auto finish_sheet = [&]() -> std::optional<Error> {
    const Picture sheet = sheet_of(pictures, kQuizColumns);
    pictures.clear();
    const auto bytes = png(sheet.width, sheet.height, sheet.rgb);
    if (!bytes) return bytes.error();
    const std::string number = std::to_string(++sheets);
    const auto written =
        write_file(out / ("sheet-" + std::string(number.size() < 2 ? "0" : "") + number + ".png"), *bytes);
    return written ? std::nullopt : std::optional(written.error());
  };
  for (std::size_t i = 0; i < items.size(); ++i) {
    const QuizItem& item = items[i];
    const std::size_t place = pictures.size();
    const std::string number = std::to_string(i + 1);
    questions += number + "," + std::to_string(sheets + 1) + "," + std::to_string(place / kQuizColumns + 1) + "," +
                 std::to_string(place % kQuizColumns + 1) + "," + centimeters(item.shown.front().size) + "," +
                 item.question + "\n";
    answers += number + "," + std::string(name_of(item.knowledge->simulator())) + "," + item.category->name + "," +
               item.answer + "\n";
    for (Picture& picture : pictures_of(item)) pictures.push_back(std::move(picture));
    if (pictures.size() < kQuizColumns * kQuizRows && i + 1 < items.size()) continue;
    if (const auto error = finish_sheet()) return refuse(*error);
  }
  for (const auto& [name, text] : {std::pair{"questions.csv", &questions}, {"answers.csv", &answers}}) {
    if (const auto written = write_file(out / name, *text); !written) return refuse(written.error());
  }
  std::printf("%zu questions on %zu sheets in %s\n", items.size(), sheets, out.string().c_str());
  return Exit::Ok;
}

Exit quiz(const QuizOptions& options, const CommandLine& program) {
  const auto known = load_backends(program.folders);
  if (!known.errors.empty()) return refuse(known.errors);
  std::vector<const Knowledge*> knowledge;
  for (const Backend& backend : known.backends) knowledge.push_back(&backend.knowledge);
  const auto* kind = std::ranges::find(kQuizKinds, options.of, &QuizKind::name);
  const auto items = kind->items(knowledge, options);
  if (items.empty()) return refuse({Error::Kind::Usage, kind->how_many, {}, "expected at least one"});
  const auto lock = prepare_folder(options.out);
  if (!lock) return refuse(lock.error());
  return write_quiz(items, options.out);
}

}  // namespace

void add_shape_quiz_command(CommandParser& shape, CommandLine& program) {
  auto options = std::make_shared<QuizOptions>();  // shared: the callback outlives this function
  auto* command = shape.add_subcommand("quiz", "Draw sheets of pictures to be named without their labels");
  command->explain(
      "What a person recognizes: things to be named, or pairs of pictures of one thing in two states or materials, to "
      "be told apart. Writes sheets of pictures, questions.csv, and apart from them answers.csv. Categories are drawn "
      "evenly over the simulators; the same seed gives the same sheets.",
      {{"unietp shape quiz things --seed 7 --out out/quiz", ""},
       {"unietp shape quiz states --count 96 --seed 7 --out out/quiz", ""}});
  std::vector<std::string> kinds;
  for (const QuizKind& kind : kQuizKinds) kinds.emplace_back(kind.name);
  command->add_option("OF", options->of, "What is asked")->one_of(kinds)->shows_default();
  command->add_option("--movables", options->movables, "Things: how many that the agent moves")->shows_default();
  command->add_option("--furniture", options->furniture, "Things: how many others")->shows_default();
  command->add_option("--count", options->count, "States and materials: how many pairs")->shows_default();
  command->add_option("--seed", options->seed, "Which categories, variants and views")->shows_default();
  command->add_option("--out", options->out, "Folder to write")->required()->output();
  command->callback([options, &program] { program.exit = quiz(*options, program); });
}

}  // namespace unietp
