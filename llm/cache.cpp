#include "llm/cache.h"

#include <exception>
#include <system_error>

namespace unietp {
namespace {

constexpr const char* kSchema = R"(
PRAGMA busy_timeout=10000; PRAGMA journal_mode=WAL; PRAGMA synchronous=NORMAL;
CREATE TABLE IF NOT EXISTS answer(digest TEXT PRIMARY KEY, model TEXT NOT NULL, text TEXT NOT NULL,
  prompt_tokens INTEGER NOT NULL, completion_tokens INTEGER NOT NULL, attempts INTEGER NOT NULL) WITHOUT ROWID;
)";

Error io_error(const std::filesystem::path& path, const std::string& reason) {
  return {Error::Kind::Io,
          path.string(),
          {},
          "cannot be used as a cache: " + reason + "; expected a file written by this program, or no file"};
}

/// Whether a database has tables, and not those of a cache.
bool is_of_others(SqliteFile& file) {
  auto tables = file.prepare("SELECT count(*), total(name = 'answer') FROM sqlite_master WHERE type = 'table'");
  tables.step();
  return tables.integer(0) > 0 && tables.integer(1) == 0;
}

}  // namespace

Result<LlmCache> LlmCache::open(const std::filesystem::path& path) {
  std::error_code code;
  if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), code);
  if (code) return io_error(path, "cannot create its folder: " + code.message());
  try {
    SqliteFile file(path, SqliteFile::Mode::Create);
    if (is_of_others(file)) return io_error(path, "it has tables of another program or purpose");
    file.run(kSchema);
    (void)file.prepare("SELECT text, prompt_tokens, completion_tokens, attempts FROM answer WHERE digest = ?");
    return LlmCache(path, std::move(file));
  } catch (const std::exception& failure) {
    return io_error(path, failure.what());
  }
}

void LlmCache::record_failure(const std::exception& exception) {
  if (!failure_) failure_ = io_error(path_, exception.what());
}

std::optional<LlmAnswer> LlmCache::find(const std::string& digest) {
  try {
    auto query = file_.prepare("SELECT text, prompt_tokens, completion_tokens, attempts FROM answer WHERE digest = ?");
    query.bind(1, std::string_view(digest));
    if (!query.step()) return std::nullopt;
    return LlmAnswer{std::string(query.text(0)), query.integer(1), query.integer(2), static_cast<int>(query.integer(3)),
                     true};
  } catch (const std::exception& failure) {
    record_failure(failure);
    return std::nullopt;
  }
}

void LlmCache::store(const std::string& digest, const std::string& model, const LlmAnswer& answer) {
  try {
    auto insert = file_.prepare("INSERT OR IGNORE INTO answer VALUES(?,?,?,?,?,?)");
    insert.bind(1, std::string_view(digest));
    insert.bind(2, std::string_view(model));
    insert.bind(3, std::string_view(answer.text));
    insert.bind(4, answer.prompt_tokens);
    insert.bind(5, answer.completion_tokens);
    insert.bind(6, std::int64_t{answer.attempts});
    insert.step();
  } catch (const std::exception& failure) {
    record_failure(failure);
  }
}

}  // namespace unietp
