#include "rewording/annotate.h"

#include <algorithm>
#include <array>
#include <set>

#include <nlohmann/json.hpp>

#include "annotator/home_facts.h"
#include "core/changed_copy.h"
#include "core/digest.h"
#include "core/files.h"
#include "core/sqlite_file.h"
#include "dataset/candidate.h"
#include "dataset/candidate_number.h"
#include "dataset/instruction_json.h"
#include "rewording/paired_wordings.h"
#include "rewording/task_lines.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

constexpr std::array<std::string_view, 3> kWriters{"grammar", "llm", "batch"};
const std::string kWordings = "wordings.jsonl";
const std::vector<std::string> kChanged{"tasks.jsonl", "dataset.sqlite", "manifest.json", kWordings};

Rng stream_of(const TaskLine& task, const AnnotateOptions& options) {
  return wording_stream(options.seed.value_or(task.seed), task.slot, task.attempt);
}

Result<std::vector<WordingTask>> wording_tasks(HomeShelf& homes, const std::vector<TaskLine>& lines,
                                               const Resources& resources, const AnnotateOptions& options) {
  std::vector<WordingTask> tasks;
  for (const TaskLine& line : lines) {
    const auto scene = read_start(homes, line);
    if (!scene) return scene.error();
    const Backend& backend = resources.backend(line.specification.simulator);
    std::set<std::string> categories;
    for (auto& name : categories_in(*scene)) categories.insert(std::move(name));
    for (auto& name : categories_of(line.specification.goal)) categories.insert(std::move(name));
    tasks.push_back({line.specification,
                     &backend.knowledge,
                     &backend.nouns,
                     {categories.begin(), categories.end()},
                     home_in_words(*scene, backend.nouns),
                     stream_of(line, options)});
  }
  return tasks;
}

/// The categories of a task's start scene, for the one style that asks what is around.
Result<std::vector<std::string>> around(HomeShelf& homes, const TaskLine& task) {
  if (task.specification.style != Style::Bystander) return std::vector<std::string>();
  const auto scene = read_start(homes, task);
  if (!scene) return scene.error();
  return categories_in(*scene);
}

Result<Instruction> by_grammar(HomeShelf& homes, const TaskLine& task, const Resources& resources,
                               const AnnotateOptions& options, const Rng& rng) {
  const auto seen = around(homes, task);
  if (!seen) return seen.error();
  const Backend& backend = resources.backend(task.specification.simulator);
  return write_instruction(task.specification, backend.knowledge, backend.nouns, {options.llm.phrasings, *seen}, rng);
}

Result<std::vector<Instruction>> written(const fs::path& folder, const std::vector<TaskLine>& lines,
                                         const Resources& resources, const AnnotateOptions& options) {
  HomeShelf homes(folder);
  std::vector<Result<Instruction>> drafts;
  if (options.writer == Writer::Grammar) {
    for (const TaskLine& line : lines)
      drafts.push_back(by_grammar(homes, line, resources, options, stream_of(line, options)));
  } else {
    const auto tasks = wording_tasks(homes, lines, resources, options);
    if (!tasks) return tasks.error();
    drafts = write_instructions_with_llm(*tasks, options.llm);
  }
  std::vector<Instruction> instructions;
  std::set<std::string> seen;  // in a home
  for (std::size_t i = 0; i < lines.size(); ++i) {
    auto& draft = drafts[i];
    const auto repeats = [&] { return seen.contains(lines[i].layout + "\n" + normalised_text(draft->text)); };
    const auto in_style = [&] { return draft->style == lines[i].specification.style; };
    constexpr std::uint64_t kOthers = 400;  // a goal has tens of texts at least, and a home few tasks of one goal
    for (std::uint64_t k = 1; draft && k <= kOthers && (repeats() || !in_style()); ++k) {
      const bool in_place = repeats() && options.writer != Writer::Grammar;
      std::string why = in_place ? "another task of this home has the model's text" : draft->why;
      draft = by_grammar(homes, lines[i], resources, options, stream_of(lines[i], options).fork("another", k));
      if (draft) draft->why = std::move(why);
    }
    if (!draft) {
      Error error = draft.error();
      error.where = (folder / "tasks.jsonl").string() + " " + lines[i].id;
      return error;
    }
    if (!in_style() || repeats())
      return Error{Error::Kind::Unsatisfiable,
                   lines[i].id,
                   {},
                   in_style() ? "no words that no other task of its home has"
                              : "no words in the style " + std::string(name_of(lines[i].specification.style))};
    seen.insert(lines[i].layout + "\n" + normalised_text(draft->text));
    instructions.push_back(std::move(*draft));
  }
  return instructions;
}

Result<Done> change_database(const fs::path& from, const fs::path& to, const std::vector<TaskLine>& lines,
                             const std::vector<Instruction>& instructions) {
  const fs::path growing = to.string() + ".growing";
  try {
    fs::copy_file(from, growing, fs::copy_options::overwrite_existing);
    SqliteFile file(growing, SqliteFile::Mode::Create);
    // A vacuum counts the schema's version up, so that each rewording would give other bytes.
    file.run(
        "PRAGMA journal_mode=OFF; PRAGMA synchronous=OFF;"
        "PRAGMA schema_version=1; BEGIN");
    auto update = file.prepare("UPDATE task SET instruction=?, style=?, writer=? WHERE id=?");
    for (std::size_t i = 0; i < lines.size(); ++i) {
      update.bind(1, std::string_view(instructions[i].text));
      update.bind(2, name_of(instructions[i].style));
      update.bind(3, std::string_view(instructions[i].writer));
      update.bind(4, std::string_view(lines[i].id));
      update.step();
      update.reset();
    }
    file.run("COMMIT");
    auto copy = file.prepare("VACUUM INTO ?");
    copy.bind(1, std::string_view(to.native()));
    copy.step();
  } catch (const std::exception& reason) {
    return Error{Error::Kind::Io, from.string(), {}, std::string("cannot change the database: ") + reason.what()};
  }
  std::error_code code;
  fs::remove(growing, code);
  return Done{};
}

Json record_of(const AnnotateReport& report, const AnnotateOptions& options) {
  Json counts = Json::array();
  for (const auto& [writer, count] : report.by_writer) counts.push_back({{"writer", writer}, {"tasks", count}});
  Json record{{"writer", name_of(options.writer)}};
  if (options.seed) record["seed"] = *options.seed;
  if (options.llm.phrasings == Phrasings::Training) record["phrasings"] = "training";
  if (options.llm.phrasings == Phrasings::Benchmark) record["phrasings"] = "benchmark";
  record["counts"] = std::move(counts);
  return record;
}

Json entry_of(const std::string& name, const std::string& bytes) {
  return {{"path", name}, {"bytes", bytes.size()}, {"sha256", sha256(bytes)}};
}

/// The manifest of the old folder with the files that changed and a note of who wrote.
Result<Done> change_manifest(const fs::path& from, const fs::path& folder, const Json& record) {
  const auto text = read_file(from);
  if (!text) return text.error();
  try {
    Json manifest = Json::parse(*text);
    std::map<std::string, Json> files;  // in order of name, as the manifest has them
    for (const auto& entry : manifest.at("files")) files[entry.at("path").get<std::string>()] = entry;
    files.erase(kWordings);
    for (const std::string& name : kChanged) {
      if (name == "manifest.json" || !fs::exists(folder / name)) continue;
      const auto bytes = read_file(folder / name);
      if (!bytes) return bytes.error();
      files[name] = entry_of(name, *bytes);
    }
    manifest["files"] = Json::array();
    for (auto& [name, entry] : files) manifest["files"].push_back(std::move(entry));
    manifest["instructions"] = record;
    return write_file(folder / "manifest.json", manifest.dump(2) + "\n");
  } catch (const Json::exception& reason) {
    return Error{Error::Kind::Schema, from.string(), {}, std::string("expected a manifest: ") + reason.what()};
  }
}

}  // namespace

std::string_view name_of(Writer writer) { return kWriters[static_cast<std::size_t>(writer)]; }

std::optional<Writer> writer_named(std::string_view name) {
  for (std::size_t i = 0; i < kWriters.size(); ++i)
    if (kWriters[i] == name) return static_cast<Writer>(i);
  return std::nullopt;
}

Result<AnnotateReport> annotate_dataset(const fs::path& folder, const fs::path& out, const Resources& resources,
                                        const AnnotateOptions& options) {
  const auto lines = read_task_lines(folder);
  if (!lines) return lines.error();
  const auto instructions = written(folder, *lines, resources, options);
  if (!instructions) return instructions.error();
  AnnotateReport report;
  std::string text;
  for (std::size_t i = 0; i < lines->size(); ++i) {
    const Instruction& instruction = (*instructions)[i];
    const TaskLine& line = (*lines)[i];
    text += reworded_line(line.text, instruction) + "\n";
    ++report.tasks;
    ++report.by_writer[instruction.writer];
    if (!instruction.why.empty()) report.stand_ins.emplace_back(line.id, instruction.why);
  }
  auto copy = ChangedCopy::begin(folder, out, kChanged);
  if (!copy) return copy.error();
  if (auto done = write_file(copy->folder() / "tasks.jsonl", text); !done) return done.error();
  if (options.paired) {
    const auto pairs = paired_wordings(folder, *lines, resources, options.llm.phrasings, options.seed);
    if (!pairs) return pairs.error();
    if (auto done = write_file(copy->folder() / kWordings, *pairs); !done) return done.error();
  }
  if (auto done = change_database(folder / "dataset.sqlite", copy->folder() / "dataset.sqlite", *lines, *instructions);
      !done)
    return done.error();
  if (auto done = change_manifest(folder / "manifest.json", copy->folder(), record_of(report, options)); !done)
    return done.error();
  if (auto done = copy->finish(); !done) return done.error();
  return report;
}

Result<std::vector<LlmRequest>> prompts_for(const fs::path& folder, const Resources& resources,
                                            const AnnotateOptions& options) {
  const auto lines = read_task_lines(folder);
  if (!lines) return lines.error();
  HomeShelf homes(folder);
  const auto tasks = wording_tasks(homes, *lines, resources, options);
  if (!tasks) return tasks.error();
  return first_requests(*tasks, options.llm);
}

}  // namespace unietp
