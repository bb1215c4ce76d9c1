#include "exports/sft.h"

#include <algorithm>
#include <charconv>
#include <optional>

#include <nlohmann/json.hpp>

#include "core/file_writer.h"
#include "core/files.h"
#include "core/png.h"
#include "core/staged_folder.h"
#include "core/text.h"
#include "environment/agent_text.h"
#include "exports/formats.h"
#include "exports/sft_chat.h"
#include "exports/sft_mistakes.h"
#include "simulation/mode_rules.h"
#include "simulation/picture.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr double kMostMistakes = 0.5;
constexpr const char* kPicture = "<image>";  // stands for a picture in a text

/// The samples of one task in one mode.
struct Samples {
  std::string lines, trl_lines;  // the second only with pictures
  std::vector<std::pair<std::string, std::string>> pictures;
  std::size_t count = 0, mistakes = 0;
};

/// A chat under construction in both forms: one text with <image> marks, and a list of parts.
class Sample {
 public:
  explicit Sample(std::string id, bool with_pictures) : id_(std::move(id)), with_pictures_(with_pictures) {}

  void say(const char* role, const std::string& text) { add(role, Json::array({words(text)}), text); }
  void show(const std::string& before, const std::string& picture, const std::string& after) {
    Json parts = Json::array();
    if (!before.empty()) parts.push_back(words(before + "\n"));
    if (!picture.empty()) {
      parts.push_back({{"type", "image"}});
      pictures_.push_back(picture);
    }
    if (!after.empty()) parts.push_back(words(after));
    std::vector<std::string> lines;
    for (const auto& part : {before, picture.empty() ? std::string() : std::string(kPicture), after}) {
      if (!part.empty()) lines.push_back(part);
    }
    add("user", std::move(parts), join(lines, "\n"));
  }
  void answer(const std::string& text, bool learn) {
    say("assistant", text);
    messages_.back()["loss"] = learn;
  }
  std::string line() const { return line_of(messages_); }
  std::string trl_line() const { return line_of(parts_); }

 private:
  static Json words(const std::string& text) { return {{"type", "text"}, {"text", text}}; }
  void add(const char* role, Json parts, const std::string& text) {
    messages_.push_back({{"role", role}, {"content", text}});
    parts_.push_back({{"role", role}, {"content", std::move(parts)}});
  }
  std::string line_of(const Json& messages) const {
    Json json{{"id", id_}, {"messages", messages}};
    if (with_pictures_) json["images"] = pictures_;
    return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
  }

  std::string id_;
  bool with_pictures_;
  Json messages_ = Json::array(), parts_ = Json::array(), pictures_ = Json::array();
};

class Maker {
 public:
  Maker(const std::vector<ValidationBackend>& backends, const SftOptions& options)
      : backends_(backends), options_(options), pictures_(options.observation != SftObservation::Boxes) {}

  Result<Samples> make(FinishedTask task, Mode mode) const {
    const auto& backend = backend_of(backends_, task.start);
    std::vector<bool> mistakes(task.shown.at(mode).steps.size(), false);
    if (options_.mistakes > 0) {
      auto erring = with_mistakes(task, mode, backend, options_.mistakes);
      if (!erring) return erring.error();
      task.shown.at(mode) = std::move(erring->shown);
      mistakes = std::move(erring->mistakes);
    }
    const bool boxes = options_.observation != SftObservation::Image && rules_of(mode).boxes;
    const auto view = !boxes ? SftView::Picture : pictures_ ? SftView::Boxes : SftView::Words;
    SftChat chat = chat_of(task, mode, backend, view, options_.reasoning);
    Samples samples;
    for (std::size_t i = 0; i < mistakes.size(); ++i) {
      if (!mistakes[i]) continue;
      chat.turns[i].worth_learning = false;
      ++samples.mistakes;
    }
    std::vector<std::string> files;
    Rays rays;
    for (std::size_t i = 0; i < chat.turns.size() && pictures_; ++i) {
      const Picture picture = picture_of(chat.turns[i].before, *backend.profile, rays);
      auto bytes = png(picture.width, picture.height, picture.rgb);
      if (!bytes) return bytes.error();
      files.push_back("images/" + task.record.id + "/" + std::string(name_of(mode)) + "-" + std::to_string(i + 1) +
                      ".png");
      samples.pictures.emplace_back(files.back(), std::move(*bytes));
    }
    files.resize(chat.turns.size());
    const std::string id = task.record.id + "/" + std::string(name_of(mode));
    if (options_.unit == SftUnit::Episode) {
      add(samples, episode(id, chat, files));
    } else {
      for (std::size_t i = 0; i < chat.turns.size(); ++i) {
        if (!mistakes[i]) add(samples, step(id + "/" + std::to_string(i + 1), chat, i, files[i]));
      }
    }
    return samples;
  }

 private:
  void add(Samples& samples, const Sample& sample) const {
    samples.lines += sample.line();
    if (pictures_) samples.trl_lines += sample.trl_line();
    ++samples.count;
  }

  Sample episode(const std::string& id, const SftChat& chat, const std::vector<std::string>& files) const {
    Sample sample(id, pictures_);
    sample.say("system", chat.system);
    for (std::size_t i = 0; i < chat.turns.size(); ++i) {
      const SftTurn& turn = chat.turns[i];
      sample.show(i == 0 ? chat.task : turn.outcome, files[i], turn.seen);
      sample.answer(turn.answer, turn.worth_learning);
    }
    return sample;
  }

  Sample step(const std::string& id, const SftChat& chat, std::size_t index, const std::string& file) const {
    Sample sample(id, pictures_);
    sample.say("system", chat.system);
    std::vector<std::string> happened;
    for (std::size_t i = 0; i < index; ++i) happened.push_back(chat.turns[i].happened);
    const std::string before = chat.task + (index > 0 ? "\n" + actions_text(happened, false) : "");
    sample.show(before, file, chat.turns[index].seen);
    sample.answer(chat.turns[index].answer, chat.turns[index].worth_learning);
    return sample;
  }

  const std::vector<ValidationBackend>& backends_;
  const SftOptions& options_;
  bool pictures_;
};

/// dataset_info.json of LLaMA-Factory: each file's columns and the names of its roles.
Json dataset_info(const std::vector<Mode>& modes, bool pictures) {
  Json info = Json::object();
  for (const Mode mode : modes) {
    Json columns{{"messages", "messages"}};
    if (pictures) columns["images"] = "images";
    info["unietp_" + lower(name_of(mode))] = {{"file_name", std::string(name_of(mode)) + ".jsonl"},
                                              {"formatting", "sharegpt"},
                                              {"columns", std::move(columns)},
                                              {"tags",
                                               {{"role_tag", "role"},
                                                {"content_tag", "content"},
                                                {"user_tag", "user"},
                                                {"assistant_tag", "assistant"},
                                                {"system_tag", "system"}}}};
  }
  return info;
}

/// Sets the modes to write and to leave out. Errors: Usage for a mode that was asked for and cannot be written.
Result<Done> choose_modes(const fs::path& dataset, const SftOptions& options, SftExport& made) {
  const auto there = shown_modes(dataset);
  for (const Mode mode : options.modes.empty() ? there : options.modes) {
    const bool shown = std::find(there.begin(), there.end(), mode) != there.end();
    const bool blind = options.observation == SftObservation::Boxes && !rules_of(mode).boxes;
    if (!options.modes.empty() && !shown)
      return Error{
          Error::Kind::Usage, "--modes", {}, "the data set has no demonstrations of " + std::string(name_of(mode))};
    if (!options.modes.empty() && blind)
      return Error{Error::Kind::Usage, "--modes", {}, "M3 has only images; expected --observation image or both"};
    (blind ? made.left_out : made.modes).push_back(mode);
  }
  return Done{};
}

}  // namespace

Result<SftExport> export_sft(const fs::path& dataset, const std::vector<ValidationBackend>& backends,
                             const SftOptions& options, const fs::path& out) {
  SftExport made;
  if (auto chosen = choose_modes(dataset, options, made); !chosen) return chosen.error();
  const bool pictures = options.observation != SftObservation::Boxes;
  const Maker maker(backends, options);
  const auto written = write_staged_folder(dataset, out, [&](const fs::path& aside) -> Result<Done> {
    for (const Mode mode : made.modes) {
      auto tasks = DatasetReader::open(dataset, {.modes = {mode}, .starts = true});
      if (!tasks) return tasks.error();
      auto file = FileWriter::begin(aside / (std::string(name_of(mode)) + ".jsonl"));
      if (!file) return file.error();
      std::optional<FileWriter> trl_file;
      if (pictures) {
        auto begun = FileWriter::begin(aside / (std::string(name_of(mode)) + ".trl.jsonl"));
        if (!begun) return begun.error();
        trl_file.emplace(std::move(*begun));
      }
      auto done = for_each_task<Samples>(
          std::move(*tasks), options.threads, [&](const FinishedTask& task) { return maker.make(task, mode); },
          [&](Samples&& samples) -> Result<Done> {
            made.samples += samples.count;
            made.pictures += samples.pictures.size();
            made.mistakes += samples.mistakes;
            for (const auto& [name, bytes] : samples.pictures) {
              if (auto drawn = write_file(aside, name, bytes); !drawn) return drawn;
            }
            if (auto added = file->add(samples.lines); !added) return added;
            return trl_file ? trl_file->add(samples.trl_lines) : Result<Done>(Done{});
          });
      if (!done) return done;
      if (auto finished = file->finish(); !finished) return finished;
      if (trl_file) {
        if (auto finished = trl_file->finish(); !finished) return finished;
      }
    }
    return write_file(aside, "dataset_info.json", dataset_info(made.modes, pictures).dump(2) + "\n");
  });
  if (!written) return written.error();
  return made;
}

namespace {

std::optional<double> number_in(std::string_view text) {
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size() ? std::optional(number) : std::nullopt;
}

/// Errors: Usage for a share of mistakes that is none.
Result<SftOptions> options_of(const ExportRequest& request) {
  SftOptions options;
  if (const std::string given = request.value("mistakes"); !given.empty()) {
    const auto share = number_in(given);
    if (!share || !(*share >= 0 && *share <= kMostMistakes))
      return Error{Error::Kind::Usage, "--mistakes", {}, "is \"" + given + "\"; expected a number from 0 to 0.5"};
    options.mistakes = *share;
  }
  options.unit = request.value("unit") == "step" ? SftUnit::Step : SftUnit::Episode;
  const auto observation = request.value("observation");
  options.observation = observation == "both"    ? SftObservation::Both
                        : observation == "image" ? SftObservation::Image
                                                 : SftObservation::Boxes;
  options.reasoning = request.has("reasoning");
  if (request.has("modes")) {
    for (const auto& name : request.options.at("modes")) options.modes.push_back(*mode_named(name));
  }
  options.threads = request.threads;
  return options;
}

std::string names_of(const std::vector<Mode>& modes) {
  std::vector<std::string> names;
  names.reserve(modes.size());
  for (const Mode mode : modes) names.emplace_back(name_of(mode));
  return join(names, ", ");
}

Result<ExportSummary> write_sft(const ExportRequest& request) {
  const auto options = options_of(request);
  if (!options) return options.error();
  const auto made = export_sft(request.dataset, request.backends, *options, request.out);
  if (!made) return made.error();
  std::string summary =
      std::to_string(made->samples) + " samples of " + names_of(made->modes) + " in " + request.out.string();
  if (options->mistakes > 0) summary += ", " + std::to_string(made->mistakes) + " mistakes";
  if (made->pictures > 0) summary += ", " + std::to_string(made->pictures) + " pictures";
  if (!made->left_out.empty())
    summary += "\n" + names_of(made->left_out) + " left out: it shows only pictures; use --observation image or both";
  std::vector<std::string> left_out;
  for (const Mode mode : made->left_out) left_out.emplace_back(name_of(mode));
  const nlohmann::ordered_json json{{"out", request.out.string()},
                                    {"samples", made->samples},
                                    {"mistakes", made->mistakes},
                                    {"pictures", made->pictures},
                                    {"modes_left_out", left_out}};
  return ExportSummary{std::move(summary), json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace)};
}

}  // namespace

ExportFormat sft_format() {
  return {"sft",
          "chats for fine-tuning (TRL, LLaMA-Factory, ms-swift)",
          {{"unit", "What a sample is", {"episode", "step"}, "episode"},
           {"observation", "What the agent is shown", {"boxes", "image", "both"}, "boxes"},
           {"modes", "Modes to write (default: all that the data set has)", {"M1", "M2", "M3"}, "", false, true},
           {"reasoning", "Add a short rationale before each action", {}, "", true},
           {"mistakes", "Put a wrong action, not learned, before this share of the steps: 0 to 0.5", {}, ""}},
          true,
          write_sft};
}

}  // namespace unietp
