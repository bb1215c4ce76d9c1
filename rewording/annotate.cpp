#include "rewording/annotate.h"

#include <array>
#include <set>

#include "annotator/home_facts.h"
#include "core/file_digest.h"
#include "core/files.h"
#include "core/staged_folder.h"
#include "dataset/dataset_database.h"
#include "record/dataset_lines.h"
#include "resources/own_phrasings.h"
#include "rewording/grammar_text.h"
#include "rewording/home_texts.h"
#include "rewording/person_text.h"
#include "rewording/worded_task.h"
#include "rewording/written_again.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 3> kWriters{"grammar", "llm", "batch"};
constexpr const char* kDatabase = "dataset.sqlite";

English english_of(const AnnotateOptions& options) { return options.english.value_or(English::Us); }

GrammarWording wording_of(const AnnotateOptions& options) {
  return {options.llm.phrasings, english_of(options), options.seed};
}

/// The options with the English of the data set where they have none.
AnnotateOptions with_english(AnnotateOptions options, const ManifestRecord& manifest) {
  if (!options.english) options.english = recorded_english(manifest.english);
  return options;
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
                       &backend.nouns_in(english_of(options)),
                       {categories.begin(), categories.end()},
                       std::make_shared<const Scene>(*scene),
                       home_in_words(*scene, backend.nouns_in(english_of(options))),
                       phrasings_of_template(resources, task.record.template_name),
                       stream_of(task.record, wording_of(options))});
  }
  return wording;
}

Result<Instruction> by_grammar(HomeCache& homes, const WordedTask& task, const Resources& resources,
                               const AnnotateOptions& options) {
  const auto start = read_start(homes, task);
  return start ? first_text(task, *start, resources, wording_of(options)) : Result<Instruction>(start.error());
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
    if (!is_kept(task, options)) drafts.push_back(by_grammar(homes, task, resources, options));
  }
  return drafts;
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

/// Hands the tasks of a folder to `use`, kAtOnce at a time, in order.
Result<Done> for_each_batch(const fs::path& folder, const std::function<Result<Done>(std::vector<WordedTask>&)>& use) {
  constexpr std::size_t kAtOnce = 512;  // many requests for a model at a time, and few megabytes
  std::vector<WordedTask> batch;
  auto read = for_each_worded_task(folder, {}, [&](WordedTask&& task) -> Result<Done> {
    batch.push_back(std::move(task));
    if (batch.size() < kAtOnce) return Done{};
    auto used = use(batch);
    batch.clear();
    return used;
  });
  if (!read || batch.empty()) return read;
  return use(batch);
}

/// Writes tasks.jsonl and dataset.sqlite with the new instructions, a batch of tasks at a time.
class Rewriting {
 public:
  Rewriting(const fs::path& folder, const Resources& resources, const AnnotateOptions& options, AnnotateReport& report,
            LinesWriter lines, RewordedDatabase database)
      : folder_(folder),
        resources_(resources),
        options_(options),
        report_(report),
        homes_(folder),
        lines_(std::move(lines)),
        database_(std::move(database)) {}

  /// A first pass: texts that stay, wherever they are in the file, and whether the files belong together, which is
  /// better known before a model is asked for hours.
  Result<Done> prepare() {
    return for_each_matched_task(folder_, [&](WordedTask&& task) -> Result<Done> {
      const TaskRecord& record = task.record;
      texts_.expect(record.layout);
      if (is_kept(task, options_)) texts_.add(record.layout, record.instruction);
      return Done{};
    });
  }

  Result<Done> add(const std::vector<WordedTask>& batch) {
    auto drafts = drafts_of(homes_, batch, resources_, options_);
    if (!drafts) return drafts.error();
    std::size_t next = 0;
    for (const WordedTask& task : batch) {
      auto instruction = is_kept(task, options_) ? Result<Instruction>(instruction_of(task))
                                                 : accepted_text(task, std::move((*drafts)[next++]));
      if (!instruction) return instruction.error();
      texts_.pass(task.record.layout);
      count(task, *instruction);
      if (auto added = lines_.add(line_of(written_again(task.record, *instruction))); !added) return added;
      if (auto added = database_.add(task.record.id, *instruction); !added) return added;
    }
    return Done{};
  }

  Result<Done> finish() {
    if (auto done = lines_.finish(); !done) return done;
    return database_.finish();
  }

 private:
  /// The draft, or another text of the grammar's where the draft repeats a text of its home or misses the style.
  Result<Instruction> accepted_text(const WordedTask& task, Result<Instruction> draft) {
    const TaskRecord& record = task.record;
    const auto repeats = [&] { return texts_.contains(record.layout, draft->text); };
    const auto in_style = [&] { return draft->style == task.specification.style; };
    for (std::uint64_t number = 1; draft && number <= kFurtherTexts && (repeats() || !in_style()); ++number) {
      const bool in_place = repeats() && options_.writer != Writer::Grammar;
      std::string why = in_place ? "another task of this home has the model's text" : draft->why;
      const auto start = read_start(homes_, task);
      draft = start ? further_text(task, *start, resources_, wording_of(options_), number, in_style())
                    : Result<Instruction>(start.error());
      if (draft) draft->why = std::move(why);
    }
    if (!draft) {
      Error error = draft.error();
      error.where = (folder_ / kTasksFile).string() + " " + record.id;
      return error;
    }
    if (!in_style() || repeats())
      return Error{Error::Kind::Unsatisfiable,
                   record.id,
                   {},
                   in_style() ? "no words that no other task of its home has"
                              : "no words in the style " + std::string(name_of(task.specification.style))};
    texts_.add(record.layout, draft->text);
    return draft;
  }

  void count(const WordedTask& task, const Instruction& instruction) {
    ++report_.tasks;
    ++report_.by_writer[instruction.writer];
    if (is_kept(task, options_)) {
      ++report_.by_people;
    } else if (!instruction.why.empty()) {
      auto& stand_ins = report_.stand_ins[instruction.why];
      if (++stand_ins.tasks == 1) stand_ins.first = task.record.id;
    }
  }

  const fs::path& folder_;
  const Resources& resources_;
  const AnnotateOptions& options_;
  AnnotateReport& report_;
  HomeCache homes_;
  LinesWriter lines_;
  RewordedDatabase database_;
  HomeTexts texts_;
};

/// Errors: those of annotate_dataset.
Result<Done> write_instructions(const fs::path& folder, const fs::path& to, const Resources& resources,
                                const AnnotateOptions& options, AnnotateReport& report) {
  auto lines = LinesWriter::begin(to / kTasksFile);
  if (!lines) return lines.error();
  auto database = RewordedDatabase::begin(folder / kDatabase, to / kDatabase);
  if (!database) return database.error();
  Rewriting rewriting(folder, resources, options, report, std::move(*lines), std::move(*database));
  if (auto done = rewriting.prepare(); !done) return done;
  if (auto done = for_each_batch(folder, [&](std::vector<WordedTask>& batch) { return rewriting.add(batch); }); !done)
    return done;
  return rewriting.finish();
}

WritingEntry writing_of(const AnnotateReport& report, const AnnotateOptions& options) {
  return {std::string(name_of(options.writer)),
          options.seed,
          std::string(name_of(options.llm.phrasings)),
          std::string(name_of(english_of(options))),
          {report.by_writer.begin(), report.by_writer.end()},
          options.paired ? std::optional(PairsEntry{options.wordings, options.contrasts}) : std::nullopt};
}

bool is_new(const std::string& file) {
  return file == kTasksFile || file == kDatabase || file == kManifest || file == kWordingsFile;
}

/// The manifest of the old folder with the files that changed.
Result<Done> write_manifest(Manifest manifest, const FrozenBenchmarks& frozen, const fs::path& folder) {
  manifest.files.erase(kWordingsFile);
  for (const char* name : {kTasksFile, kDatabase, kWordingsFile}) {
    std::error_code code;
    if (!fs::exists(folder / name, code)) continue;
    auto digest = digest_of_file(folder, name);
    if (!digest) return digest.error();
    manifest.files[name] = {digest->bytes, std::move(digest->sha256)};
  }
  manifest.benchmark = benchmark_of(manifest.files, frozen);
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
                                        const AnnotateOptions& asked) {
  // First of all, so that the folder stays as it is read, and one that cannot be written is known before hours of work.
  auto copy = ChangedCopy::begin(folder, out, is_new);
  if (!copy) return copy.error();
  const auto recorded = read_manifest_file(folder);
  if (!recorded) return recorded.error();
  const AnnotateOptions options = with_english(asked, *recorded);
  auto manifest = written_again((folder / kManifest).string(), *recorded);
  if (!manifest) return manifest.error();
  AnnotateReport report;
  if (auto done = write_instructions(folder, copy->folder(), resources, counting(options, report), report); !done)
    return done.error();
  if (report.unanswered > 0 && !options.stand_in) return report;
  if (options.paired) {
    auto pairs = write_paired_wordings(
        folder, resources,
        {options.llm.phrasings, english_of(options), options.seed, options.contrasts, options.wordings},
        copy->folder() / kWordingsFile);
    if (!pairs) return pairs.error();
    report.pairs = std::move(*pairs);
  }
  manifest->writing = writing_of(report, options);
  if (auto done = write_manifest(std::move(*manifest), resources.frozen, copy->folder()); !done) return done.error();
  if (auto done = copy->finish(); !done) return done.error();
  report.written = true;
  return report;
}

Result<Done> prompts_for(const fs::path& folder, const Resources& resources, const AnnotateOptions& asked,
                         const std::function<void(const std::vector<LlmRequest>&)>& use) {
  const auto recorded = read_manifest_file(folder);
  if (!recorded) return recorded.error();
  const AnnotateOptions options = with_english(asked, *recorded);
  HomeCache homes(folder);
  return for_each_batch(folder, [&](std::vector<WordedTask>& batch) -> Result<Done> {
    const auto wording = wording_tasks(homes, batch, resources, options);
    if (!wording) return wording.error();
    use(first_requests(*wording, options.llm));
    return Done{};
  });
}

}  // namespace unietp
