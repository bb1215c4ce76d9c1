#include "run/ledger.h"

#include <array>
#include <exception>
#include <string_view>

#include "core/file_writer.h"
#include "core/text.h"

namespace unietp {
namespace {

// WAL with synchronous=NORMAL: a killed process loses nothing, and a commit needs no disk flush. A checkpoint, every
// 32 MB, flushes and makes all threads wait. A candidate is about 25 KB, so pages of 8 KB waste little.
constexpr const char* kPragmas =
    "PRAGMA page_size=8192; PRAGMA journal_mode=WAL; PRAGMA synchronous=NORMAL; PRAGMA wal_autocheckpoint=4096;";

/// The columns of a candidate between `accepted` and `cost`, all texts, in the order of `texts_of`.
constexpr std::array<std::string_view, 22> kTexts{
    "template",  "simulator", "split",  "id",    "scene",    "layout",  "goal", "instruction",
    "style",     "writer",    "sense",  "forms", "bindings", "actions", "task", "demonstration",
    "start_key", "text_key",  "traits", "stage", "reason",   "detail"};

/// What a candidate's row says in another form than its record does.
struct OwnTexts {
  std::string simulator, split;  // of the task or of the rejection
  std::string bindings, actions;
  std::string shown;  // the lines of the demonstrations
};

/// The texts of a row, to be written from or read into: the one place where a column gets its field.
template <class Record, class Own>
auto texts_of(Record& record, Own& own) -> std::array<decltype(&record.template_name), kTexts.size()> {
  auto& row = record.task.row;
  auto& rejection = record.rejection;
  return {&record.template_name,
          &own.simulator,
          &own.split,
          &row.id,
          &row.scene,
          &row.layout,
          &row.goal,
          &row.instruction,
          &row.style,
          &row.writer,
          &row.sense,
          &row.forms,
          &own.bindings,
          &own.actions,
          &record.task.line,
          &own.shown,
          &record.start_key,
          &record.text_key,
          &record.traits,
          &rejection.stage,
          &rejection.reason,
          &rejection.detail};
}

/// `before` and `after` around each column of texts, in order.
std::string columns(std::string_view before, std::string_view after) {
  std::string text;
  for (const std::string_view name : kTexts) text.append(before).append(name).append(after);
  return text;
}

/// The tables and a view of the outcome of each candidate, for people; `to` is the database that they are made in.
/// A cost is a JSON object of seconds by stage.
std::string schema(const std::string& to) {
  return "CREATE TABLE IF NOT EXISTS " + to + ".run(identity TEXT NOT NULL);" + "CREATE TABLE IF NOT EXISTS " + to +
         ".candidate(slot INTEGER NOT NULL, attempt INTEGER NOT NULL, accepted INTEGER NOT NULL" +
         columns(", ", " TEXT NOT NULL") + R"(, cost TEXT NOT NULL, PRIMARY KEY(slot, attempt));
CREATE TABLE IF NOT EXISTS )" +
         to + R"(.home(layout TEXT PRIMARY KEY, scene TEXT NOT NULL);
CREATE VIEW IF NOT EXISTS )" +
         to + R"(.outcome AS SELECT slot, attempt, template, accepted,
  CASE accepted WHEN 0 THEN stage END AS stage, CASE accepted WHEN 0 THEN reason END AS reason,
  (SELECT sum(value) FROM json_each(cost)) AS seconds, cost FROM candidate;
)";
}

std::string text_of(const StageCosts& costs) {
  std::string text;
  for (std::size_t i = 0; i < kStageCount; ++i) {
    if (costs.seconds[i] <= 0) continue;
    text += (text.empty() ? "{\"" : ",\"") + std::string(name_of(static_cast<Stage>(i))) +
            "\":" + number_text(costs.seconds[i]);
  }
  return text.empty() ? "{}" : text + "}";
}

Error failure(std::string_view what, const std::exception& reason) {
  return {Error::Kind::Io, "ledger.sqlite", {}, std::string(what) + ": " + reason.what()};
}

Error no_candidate(int slot, int attempt, std::string_view why) {
  return {Error::Kind::Io,
          "ledger.sqlite",
          {},
          "candidate " + std::to_string(attempt) + " of slot " + std::to_string(slot) + " " + std::string(why)};
}

std::string repeated(std::string_view part, std::size_t times) {
  std::string text;
  for (std::size_t i = 0; i < times; ++i) text += part;
  return text;
}

}  // namespace

Result<Ledger> Ledger::open(const std::filesystem::path& path, const std::string& identity) {
  try {
    SqliteFile file(path, SqliteFile::Mode::Create);
    file.run(kPragmas);
    file.run(schema("main").c_str());
    std::string stored;
    {
      auto query = file.prepare("SELECT identity FROM run");
      if (query.step()) stored = query.text(0);
    }
    if (stored.empty()) {
      auto insert = file.prepare("INSERT INTO run VALUES(?)");
      insert.bind(1, std::string_view(identity));
      insert.step();
    } else if (stored != identity) {
      return Error{Error::Kind::Usage,
                   path.parent_path().string(),
                   {},
                   "contains an unfinished run with different settings, so it cannot be resumed\n  it was: " + stored +
                       "\n  asked:  " + identity +
                       "\nrepeat the command with the same options and program, or remove that folder to start anew"};
    }
    return Ledger(std::move(file));
  } catch (const std::exception& reason) {
    return failure("cannot open " + path.string(), reason);
  }
}

Result<Ledger> Ledger::read_only(const std::filesystem::path& path, const std::string& identity) {
  try {
    SqliteFile file(path, SqliteFile::Mode::Read);
    auto query = file.prepare("SELECT identity FROM run");
    if (!query.step() || query.text(0) != identity)
      return Error{Error::Kind::Usage, path.string(), {}, "belongs to a different run than its folder"};
    return Ledger(std::move(file));
  } catch (const std::exception& reason) {
    return failure("cannot read " + path.string(), reason);
  }
}

Result<Done> Ledger::check_replaceable(const std::filesystem::path& path) {
  std::error_code code;
  if (!std::filesystem::exists(std::filesystem::symlink_status(path, code))) return Done{};
  try {
    SqliteFile file(path, SqliteFile::Mode::Read);
    (void)file.prepare("SELECT identity FROM run");
    (void)file.prepare("SELECT slot, attempt, accepted" + columns(", ", "") + ", cost FROM candidate");
    return Done{};
  } catch (const std::exception& reason) {
    return Error{Error::Kind::Usage,
                 path.string(),
                 {},
                 std::string("exists and is no ledger of this program: ") + reason.what() +
                     "; choose another file, or remove this one first"};
  }
}

Result<Done> Ledger::copy_to(const std::filesystem::path& path, bool with_costs) {
  const std::scoped_lock lock(*mutex_);
  try {
    {
      auto attach = file_.prepare("ATTACH ? AS copy");
      attach.bind(1, std::string_view(path.native()));
      attach.step();
    }
    file_.run("PRAGMA copy.page_size=32768; PRAGMA copy.journal_mode=MEMORY; PRAGMA copy.synchronous=OFF;");
    file_.run(schema("copy").c_str());
    const std::string cost = with_costs ? "cost" : "'{}'";
    const std::string fill =
        "BEGIN; INSERT INTO copy.run SELECT identity FROM main.run; INSERT INTO copy.candidate SELECT slot, attempt, "
        "accepted" +
        columns(", ", "") + ", " + cost +
        " FROM main.candidate ORDER BY slot, attempt; INSERT INTO copy.home SELECT layout, scene FROM main.home ORDER "
        "BY layout; COMMIT; DETACH copy;";
    file_.run(fill.c_str());
    return confirm_written(path);
  } catch (const std::exception& reason) {
    return failure("cannot write " + path.string(), reason);
  }
}

Result<Done> Ledger::add(const CandidateRecord& record, const StageCosts& costs) {
  const std::scoped_lock lock(*mutex_);
  try {
    const std::string cost = text_of(costs);
    static const std::string kInsert = "INSERT INTO candidate VALUES(?,?,?" + repeated(",?", kTexts.size()) + ",?)";
    auto insert = file_.prepare(kInsert);
    insert.bind(1, std::int64_t{record.slot});
    insert.bind(2, std::int64_t{record.attempt});
    insert.bind(3, std::int64_t{record.accepted});
    int column = 3;
    const TaskRow& row = record.task.row;
    const OwnTexts own{record.accepted ? row.simulator : record.rejection.simulator,
                       record.accepted ? row.split : record.rejection.split, bindings_text(row), actions_text(row),
                       join(record.task.shown, "\n")};
    for (const std::string* text : texts_of(record, own)) insert.bind(++column, std::string_view(*text));
    insert.bind(++column, std::string_view(cost));
    insert.step();
    return Done{};
  } catch (const std::exception& reason) {
    return failure("cannot store a candidate", reason);
  }
}

Result<Done> Ledger::keep_home(const std::string& layout, const std::function<std::string()>& packed) {
  const std::scoped_lock lock(*mutex_);
  try {
    auto known = file_.prepare("SELECT 1 FROM home WHERE layout = ?");
    known.bind(1, std::string_view(layout));
    if (known.step()) return Done{};
    const std::string scene = packed();
    auto insert = file_.prepare("INSERT INTO home VALUES(?,?)");
    insert.bind(1, std::string_view(layout));
    insert.bind(2, std::string_view(scene));
    insert.step();
    return Done{};
  } catch (const std::exception& reason) {
    return failure("cannot store a home", reason);
  }
}

Result<std::string> Ledger::home(const std::string& layout) {
  const std::scoped_lock lock(*mutex_);
  try {
    auto query = file_.prepare("SELECT scene FROM home WHERE layout = ?");
    query.bind(1, std::string_view(layout));
    if (!query.step()) return Error{Error::Kind::Io, "ledger.sqlite", {}, "lacks the home " + layout};
    return std::string(query.text(0));
  } catch (const std::exception& reason) {
    return failure("cannot read a home", reason);
  }
}

Result<std::vector<CandidateRecord>> Ledger::outlines(int first, int slots) {
  const std::scoped_lock lock(*mutex_);
  try {
    std::vector<CandidateRecord> records;
    auto query = file_.prepare(
        "SELECT slot, attempt, accepted, template, start_key, text_key, traits, reason FROM candidate "
        "WHERE slot >= ? AND slot < ? ORDER BY attempt, slot");
    query.bind(1, std::int64_t{first});
    query.bind(2, std::int64_t{first} + slots);
    while (query.step()) {
      CandidateRecord record;
      record.slot = static_cast<int>(query.integer(0));
      record.attempt = static_cast<int>(query.integer(1));
      record.accepted = query.integer(2) != 0;
      record.template_name = query.text(3);
      record.start_key = query.text(4);
      record.text_key = query.text(5);
      record.traits = query.text(6);
      record.rejection.reason = query.text(7);
      records.push_back(std::move(record));
    }
    return records;
  } catch (const std::exception& reason) {
    return failure("cannot read the candidates", reason);
  }
}

Result<CandidateRecord> Ledger::read(int slot, int attempt) {
  const std::scoped_lock lock(*mutex_);
  try {
    static const std::string kSelect =
        "SELECT accepted" + columns(", ", "") + " FROM candidate WHERE slot = ? AND attempt = ?";
    auto query = file_.prepare(kSelect);
    query.bind(1, std::int64_t{slot});
    query.bind(2, std::int64_t{attempt});
    if (!query.step()) return no_candidate(slot, attempt, "is missing");
    CandidateRecord record;
    record.slot = slot;
    record.attempt = attempt;
    record.accepted = query.integer(0) != 0;
    TaskRow& row = record.task.row;
    RejectionEntry& rejection = record.rejection;
    OwnTexts own;
    int column = 0;
    for (std::string* text : texts_of(record, own)) *text = query.text(++column);
    if (!record.accepted) {
      rejection.slot = slot;
      rejection.attempt = attempt;
      rejection.template_name = record.template_name;
      rejection.simulator = std::move(own.simulator);
      rejection.split = std::move(own.split);
      return record;
    }
    row.template_name = record.template_name;
    row.simulator = std::move(own.simulator);
    row.split = std::move(own.split);
    auto read_bindings = bindings_from(own.bindings);
    auto read_actions = actions_from(own.actions);
    if (!read_bindings || !read_actions) return no_candidate(slot, attempt, "is damaged");
    row.bindings = std::move(*read_bindings);
    row.actions = std::move(*read_actions);
    record.task.shown = split(own.shown, '\n');
    return record;
  } catch (const std::exception& reason) {
    return failure("cannot read a candidate", reason);
  }
}

}  // namespace unietp
