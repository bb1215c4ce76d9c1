#include "rewording/annotate.h"

#include <array>
#include <set>

#include "annotator/home_facts.h"
#include "core/file_digest.h"
#include "core/files.h"
#include "core/staged_folder.h"
#include "dataset/candidate.h"
#include "dataset/candidate_number.h"
#include "dataset/dataset_database.h"
#include "record/dataset_lines.h"
#include "rewording/paired_wordings.h"
#include "rewording/person_text.h"
#include "rewording/worded_task.h"
#include "rewording/written_again.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 3> kWriters{"grammar", "llm", "batch"};
constexpr const char* kDatabase = "dataset.sqlite";

Rng stream_of(const WordedTask& task, const AnnotateOptions& options) {
  const TaskRecord& record = task.record;
  return wording_stream(options.seed.value_or(record.run), record.slot, record.attempt);
}

bool is_kept(const WordedTask& task, const AnnotateOptions& options) {
  return !options.replace_human && by_person(task.record.writer);
}

/// Of the tasks whose text is to be written.
Result<std::vector<WordingTask>> wording_tasks(HomeCache& homes, const std::vector<WordedTask>& tasks,
                                               const Resources& resources, const AnnotateOptions& options) {
  std::vector<WordingTask> wording;
  for (const WordedTask& task : tasks) {
    if (is_kept(task, options)) continue;
    const auto scene = read_start(homes, task);
    if (!scene) return scene.error();
    const Backend& backend = resources.backend(task.specification.simulator);
    std::set<std::string> categories;
    for (auto& name : categories_in(*scene)) categories.insert(std::move(name));
    for (auto& name : categories_of(task.specification.goal)) categories.insert(std::move(name));
    wording.push_back({task.specification,
                       &backend.knowledge,
                       &backend.nouns,
                       {categories.begin(), categories.end()},
                       home_in_words(*scene, backend.nouns),
                       stream_of(task, options)});
  }
  return wording;
}

/// The categories of a task's start scene, for the one style that asks what is around.
Result<std::vector<std::string>> around(HomeCache& homes, const WordedTask& task) {
  if (task.specification.style != Style::Bystander) return std::vector<std::string>();
  const auto scene = read_start(homes, task);
  if (!scene) return scene.error();
  return categories_in(*scene);
}

Result<Instruction> by_grammar(HomeCache& homes, const WordedTask& task, const Resources& resources,
                               const AnnotateOptions& options, const Rng& rng) {
  const auto seen = around(homes, task);
  if (!seen) return seen.error();
  const Backend& backend = resources.backend(task.specification.simulator);
  return write_instruction(task.specification, backend.knowledge, backend.nouns, {options.llm.phrasings, *seen}, rng);
}

std::string text_key(const WordedTask& task, const Instruction& instruction) {
  return task.record.layout + "\n" + normalised_text(instruction.text);
}

/// What the writer gives for each task whose text is to be written, in their order.
Result<std::vector<Result<Instruction>>> drafts_of(HomeCache& homes, const std::vector<WordedTask>& tasks,
                                                   const Resources& resources, const AnnotateOptions& options) {
  if (options.writer != Writer::Grammar) {
    const auto wording = wording_tasks(homes, tasks, resources, options);
    if (!wording) return wording.error();
    return write_instructions_with_llm(*wording, options.llm);
  }
  std::vector<Result<Instruction>> drafts;
  for (const WordedTask& task : tasks) {
    if (!is_kept(task, options))
      drafts.push_back(by_grammar(homes, task, resources, options, stream_of(task, options)));
  }
  return drafts;
}

Result<std::vector<Instruction>> instructions_for(const fs::path& folder, const std::vector<WordedTask>& tasks,
                                                  const Resources& resources, const AnnotateOptions& options) {
  HomeCache homes(folder);
  auto drafts = drafts_of(homes, tasks, resources, options);
  if (!drafts) return drafts.error();
  std::set<std::string> seen;  // in a home
  for (const WordedTask& task : tasks) {
    if (is_kept(task, options)) seen.insert(text_key(task, instruction_of(task)));
  }
  std::vector<Instruction> instructions;
  std::size_t next = 0;
  for (const WordedTask& task : tasks) {
    if (is_kept(task, options)) {
      instructions.push_back(instruction_of(task));
      continue;
    }
    auto& draft = (*drafts)[next++];
    const auto repeats = [&] { return seen.contains(text_key(task, *draft)); };
    const auto in_style = [&] { return draft->style == task.specification.style; };
    constexpr std::uint64_t kOthers = 400;  // a goal has tens of texts at least, and a home few tasks of one goal
    for (std::uint64_t k = 1; draft && k <= kOthers && (repeats() || !in_style()); ++k) {
      const bool in_place = repeats() && options.writer != Writer::Grammar;
      std::string why = in_place ? "another task of this home has the model's text" : draft->why;
      draft = by_grammar(homes, task, resources, options, stream_of(task, options).fork("another", k));
      if (draft) draft->why = std::move(why);
    }
    if (!draft) {
      Error error = draft.error();
      error.where = (folder / kTasksFile).string() + " " + task.record.id;
      return error;
    }
    if (!in_style() || repeats())
      return Error{Error::Kind::Unsatisfiable,
                   task.record.id,
                   {},
                   in_style() ? "no words that no other task of its home has"
                              : "no words in the style " + std::string(name_of(task.specification.style))};
    seen.insert(text_key(task, *draft));
    instructions.push_back(std::move(*draft));
  }
  return instructions;
}

/// The options with a model that also counts in the report what it leaves unanswered.
AnnotateOptions counting(AnnotateOptions options, AnnotateReport& report) {
  options.llm.ask = [ask = std::move(options.llm.ask), &report](const std::vector<LlmRequest>& requests) {
    auto answers = ask(requests);
    for (const auto& answer : answers) {
      if (answer || answer.error().kind == Error::Kind::Schema) continue;  // an answer, if one of no use
      if (++report.unanswered == 1) report.no_answer = answer.error().message;
    }
    return answers;
  };
  return options;
}

/// tasks.jsonl and dataset.sqlite with the new instructions.
Result<Done> write_instructions(const fs::path& from, const fs::path& to, const std::vector<WordedTask>& tasks,
                                const std::vector<Instruction>& instructions) {
  auto lines = LinesWriter::begin(to / kTasksFile);
  if (!lines) return lines.error();
  std::vector<std::pair<std::string, Instruction>> by_task;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    if (auto added = lines->add(line_of(written_again(tasks[i].record, instructions[i]))); !added) return added;
    by_task.emplace_back(tasks[i].record.id, instructions[i]);
  }
  if (auto done = lines->finish(); !done) return done;
  return reword_database(from / kDatabase, to / kDatabase, by_task);
}

WritingEntry writing_of(const AnnotateReport& report, const AnnotateOptions& options) {
  return {std::string(name_of(options.writer)),
          options.seed,
          std::string(name_of(options.llm.phrasings)),
          {report.by_writer.begin(), report.by_writer.end()}};
}

bool is_new(const std::string& file) {
  return file == kTasksFile || file == kDatabase || file == kManifest || file == kWordingsFile;
}

/// The manifest of the old folder with the files that changed.
Result<Done> write_manifest(Manifest manifest, const fs::path& folder) {
  manifest.files.erase(kWordingsFile);
  for (const char* name : {kTasksFile, kDatabase, kWordingsFile}) {
    std::error_code code;
    if (!fs::exists(folder / name, code)) continue;
    auto digest = digest_of_file(folder, name);
    if (!digest) return digest.error();
    manifest.files[name] = {digest->bytes, std::move(digest->sha256)};
  }
  return write_file(folder, kManifest, to_text(manifest));
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
  // First of all, so that the folder stays as it is read, and one that cannot be written is known before hours of work.
  auto copy = ChangedCopy::begin(folder, out, is_new);
  if (!copy) return copy.error();
  const auto recorded = read_manifest_file(folder);
  if (!recorded) return recorded.error();
  auto manifest = written_again((folder / kManifest).string(), *recorded);
  if (!manifest) return manifest.error();
  const auto tasks = read_worded_tasks(folder);
  if (!tasks) return tasks.error();
  AnnotateReport report;
  const auto instructions = instructions_for(folder, *tasks, resources, counting(options, report));
  if (!instructions) return instructions.error();
  if (report.unanswered > 0 && !options.stand_in) return report;
  for (std::size_t i = 0; i < tasks->size(); ++i) {
    const Instruction& instruction = (*instructions)[i];
    ++report.tasks;
    ++report.by_writer[instruction.writer];
    if (is_kept((*tasks)[i], options)) {
      ++report.by_people;
    } else if (!instruction.why.empty()) {
      report.stand_ins.emplace_back((*tasks)[i].record.id, instruction.why);
    }
  }
  if (auto done = write_instructions(folder, copy->folder(), *tasks, *instructions); !done) return done.error();
  if (options.paired) {
    if (auto done = write_paired_wordings(folder, *tasks, resources, {options.llm.phrasings, options.seed},
                                          copy->folder() / kWordingsFile);
        !done)
      return done.error();
  }
  manifest->writing = writing_of(report, options);
  if (auto done = write_manifest(std::move(*manifest), copy->folder()); !done) return done.error();
  if (auto done = copy->finish(); !done) return done.error();
  report.written = true;
  return report;
}

Result<std::vector<LlmRequest>> prompts_for(const fs::path& folder, const Resources& resources,
                                            const AnnotateOptions& options) {
  const auto tasks = read_worded_tasks(folder);
  if (!tasks) return tasks.error();
  HomeCache homes(folder);
  const auto wording = wording_tasks(homes, *tasks, resources, options);
  if (!wording) return wording.error();
  return first_requests(*wording, options.llm);
}

}  // namespace unietp
