#include "dataset/dataset_database.h"

#include <exception>
#include <initializer_list>
#include <string_view>

#include "core/file_writer.h"
#include "dataset/balance.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;

constexpr const char* kSchema = R"(
PRAGMA page_size=4096; PRAGMA journal_mode=OFF; PRAGMA synchronous=OFF;
CREATE TABLE task(id TEXT PRIMARY KEY, template TEXT NOT NULL, split TEXT NOT NULL, simulator TEXT NOT NULL,
  scene TEXT NOT NULL, layout TEXT NOT NULL, goal TEXT NOT NULL, instruction TEXT NOT NULL, style TEXT NOT NULL,
  writer TEXT NOT NULL, sense TEXT NOT NULL, forms TEXT NOT NULL, steps INTEGER NOT NULL, failures INTEGER NOT NULL) STRICT;
CREATE TABLE binding(task TEXT NOT NULL REFERENCES task, placeholder TEXT NOT NULL, category TEXT NOT NULL) STRICT;
CREATE TABLE step(task TEXT NOT NULL REFERENCES task, mode TEXT NOT NULL, number INTEGER NOT NULL, action TEXT NOT NULL,
  arguments TEXT NOT NULL, success INTEGER NOT NULL, failure TEXT NOT NULL) STRICT;
CREATE TABLE trait(task TEXT NOT NULL REFERENCES task, dimension TEXT NOT NULL, value TEXT NOT NULL) STRICT;
CREATE TABLE rejection(slot INTEGER NOT NULL, attempt INTEGER NOT NULL, template TEXT NOT NULL, simulator TEXT NOT NULL,
  split TEXT NOT NULL, stage TEXT NOT NULL, reason TEXT NOT NULL, detail TEXT NOT NULL) STRICT;
BEGIN;
)";

fs::path growing(const fs::path& path) { return path.string() + ".growing"; }

Error failure(const fs::path& path, const std::exception& reason) {
  return {Error::Kind::Io, path.string(), {}, std::string("cannot write the database: ") + reason.what()};
}

Error unchanged(const fs::path& path, const std::exception& reason) {
  return {Error::Kind::Io, path.string(), {}, std::string("cannot change the database: ") + reason.what()};
}

void bind_texts(Statement& statement, int first, std::initializer_list<std::string_view> texts) {
  for (const auto text : texts) statement.bind(first++, text);
}

}  // namespace

Result<DatasetDatabase> DatasetDatabase::begin(const fs::path& path) {
  try {
    SqliteFile file(growing(path), SqliteFile::Mode::Create);
    file.run(kSchema);
    return DatasetDatabase(path, std::move(file));
  } catch (const std::exception& reason) {
    return failure(path, reason);
  }
}

Result<Done> DatasetDatabase::add_task(const TaskRow& task, const std::vector<Trait>& traits) {
  try {
    auto insert = file_.prepare("INSERT INTO task VALUES(?,?,?,?,?,?,?,?,?,?,?,?,?,?)");
    bind_texts(insert, 1,
               {task.id, task.template_name, task.split, task.simulator, task.scene, task.layout, task.goal,
                task.instruction, task.style, task.writer, task.sense, task.forms});
    const auto [steps, failures] = steps_and_failures(task, Mode::M1);
    insert.bind(13, std::int64_t{steps});
    insert.bind(14, std::int64_t{failures});
    insert.step();
    auto binding = file_.prepare("INSERT INTO binding VALUES(?,?,?)");
    for (const auto& [placeholder, category] : task.bindings) {
      bind_texts(binding, 1, {task.id, placeholder, category});
      binding.step();
      binding.reset();
    }
    auto own = file_.prepare("INSERT INTO trait VALUES(?,?,?)");
    for (const auto& trait : traits) {
      bind_texts(own, 1, {task.id, name_of(trait.dimension), trait.value});
      own.step();
      own.reset();
    }
    auto step = file_.prepare("INSERT INTO step VALUES(?,?,?,?,?,?,?)");
    std::int64_t number = 0;
    for (std::size_t i = 0; i < task.actions.size(); ++i) {
      const ActionRow& action = task.actions[i];
      number = i > 0 && task.actions[i - 1].mode == action.mode ? number + 1 : 1;
      bind_texts(step, 1, {task.id, name_of(action.mode)});
      step.bind(3, number);
      bind_texts(step, 4, {action.action, action.arguments});
      step.bind(6, std::int64_t{action.success});
      step.bind(7, std::string_view(action.failure));
      step.step();
      step.reset();
    }
    return Done{};
  } catch (const std::exception& reason) {
    return failure(path_, reason);
  }
}

Result<Done> DatasetDatabase::add_rejection(const RejectionEntry& rejection) {
  try {
    auto insert = file_.prepare("INSERT INTO rejection VALUES(?,?,?,?,?,?,?,?)");
    insert.bind(1, std::int64_t{rejection.slot});
    insert.bind(2, std::int64_t{rejection.attempt});
    bind_texts(insert, 3,
               {rejection.template_name, rejection.simulator, rejection.split, rejection.stage, rejection.reason,
                rejection.detail});
    insert.step();
    return Done{};
  } catch (const std::exception& reason) {
    return failure(path_, reason);
  }
}

Result<Done> DatasetDatabase::finish() {
  try {
    file_.run("COMMIT");
    auto copy = file_.prepare("VACUUM INTO ?");
    copy.bind(1, std::string_view(path_.native()));
    copy.step();
    fs::remove(growing(path_));
    return confirm_written(path_);
  } catch (const std::exception& reason) {
    return failure(path_, reason);
  }
}

Result<RewordedDatabase> RewordedDatabase::begin(const fs::path& from, const fs::path& to) {
  try {
    fs::copy_file(from, growing(to), fs::copy_options::overwrite_existing);
    SqliteFile file(growing(to), SqliteFile::Mode::Create);
    // A vacuum counts the schema's version up, so that each rewording would give other bytes.
    file.run(
        "PRAGMA journal_mode=OFF; PRAGMA synchronous=OFF;"
        "PRAGMA schema_version=1; BEGIN");
    auto update = file.prepare("UPDATE task SET instruction=?, style=?, writer=? WHERE id=?");
    return RewordedDatabase(from, to, std::move(file), std::move(update));
  } catch (const std::exception& reason) {
    return unchanged(from, reason);
  }
}

Result<Done> RewordedDatabase::add(const std::string& task, const Instruction& instruction) {
  try {
    bind_texts(update_, 1, {instruction.text, name_of(instruction.style), instruction.writer, task});
    update_.step();
    update_.reset();
    return Done{};
  } catch (const std::exception& reason) {
    return unchanged(from_, reason);
  }
}

Result<Done> RewordedDatabase::finish() {
  try {
    file_.run("COMMIT");
    auto vacuum = file_.prepare("VACUUM INTO ?");
    vacuum.bind(1, std::string_view(to_.native()));
    vacuum.step();
    fs::remove(growing(to_));
    return confirm_written(to_);
  } catch (const std::exception& reason) {
    return unchanged(from_, reason);
  }
}

}  // namespace unietp
