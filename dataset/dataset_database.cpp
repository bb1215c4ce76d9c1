#include "dataset/dataset_database.h"

#include <exception>

#include <nlohmann/json.hpp>

#include "core/text.h"
#include "dataset/balance.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

constexpr const char* kSchema = R"(
PRAGMA page_size=4096; PRAGMA journal_mode=OFF; PRAGMA synchronous=OFF;
CREATE TABLE task(id TEXT PRIMARY KEY, template TEXT NOT NULL, split TEXT NOT NULL, simulator TEXT NOT NULL,
  scene TEXT NOT NULL, layout TEXT NOT NULL, goal TEXT NOT NULL, instruction TEXT NOT NULL, style TEXT NOT NULL,
  writer TEXT NOT NULL, steps INTEGER NOT NULL, failures INTEGER NOT NULL) STRICT;
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

std::string text_at(const Json& json, const char* pointer) {
  return json.at(Json::json_pointer(pointer)).get<std::string>();
}

void bind_texts(Statement& statement, const Json& json, std::initializer_list<const char*> pointers, int first) {
  for (const char* pointer : pointers) statement.bind(first++, std::string_view(text_at(json, pointer)));
}

std::string texts_of(const Json& list) {
  std::vector<std::string> parts;
  for (const auto& part : list) parts.push_back(part.is_string() ? part.get<std::string>() : part.dump());
  return join(parts, ", ");
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

Result<Done> DatasetDatabase::add_task(const Json& task, const std::vector<Json>& demonstrations,
                                       const std::vector<Trait>& traits) {
  try {
    const auto id = text_at(task, "/id");
    auto insert = file_.prepare("INSERT INTO task VALUES(?,?,?,?,?,?,?,?,?,?,?,?)");
    bind_texts(insert, task,
               {"/id", "/template", "/split", "/simulator", "/scene", "/layout", "/goal/text", "/instruction/text",
                "/instruction/style", "/instruction/writer"},
               1);
    insert.bind(11, task.at("/expert/M1/steps"_json_pointer).get<std::int64_t>());
    insert.bind(12, task.at("/expert/M1/failures"_json_pointer).get<std::int64_t>());
    insert.step();
    auto bind = file_.prepare("INSERT INTO binding VALUES(?,?,?)");
    for (const auto& [placeholder, category] : task.at("bindings").items()) {
      bind.bind(1, std::string_view(id));
      bind.bind(2, std::string_view(placeholder));
      bind.bind(3, std::string_view(category.get_ref<const std::string&>()));
      bind.step();
      bind.reset();
    }
    auto lies = file_.prepare("INSERT INTO trait VALUES(?,?,?)");
    for (const auto& trait : traits) {
      lies.bind(1, std::string_view(id));
      lies.bind(2, name_of(trait.dimension));
      lies.bind(3, std::string_view(trait.value));
      lies.step();
      lies.reset();
    }
    auto step = file_.prepare("INSERT INTO step VALUES(?,?,?,?,?,?,?)");
    for (const auto& demonstration : demonstrations) {
      const auto mode = text_at(demonstration, "/mode");
      std::int64_t number = 0;
      for (const auto& one : demonstration.at("steps")) {
        step.bind(1, std::string_view(id));
        step.bind(2, std::string_view(mode));
        step.bind(3, ++number);
        step.bind(4, std::string_view(text_at(one, "/action")));
        step.bind(5, std::string_view(texts_of(one.at("args"))));
        step.bind(6, std::int64_t{one.at("success").get<bool>()});
        step.bind(7, std::string_view(text_at(one, "/failure")));
        step.step();
        step.reset();
      }
    }
    return Done{};
  } catch (const std::exception& reason) {
    return failure(path_, reason);
  }
}

Result<Done> DatasetDatabase::add_rejection(const Json& rejection) {
  try {
    auto insert = file_.prepare("INSERT INTO rejection VALUES(?,?,?,?,?,?,?,?)");
    insert.bind(1, rejection.at("slot").get<std::int64_t>());
    insert.bind(2, rejection.at("attempt").get<std::int64_t>());
    bind_texts(insert, rejection, {"/template", "/simulator", "/split", "/stage", "/reason", "/detail"}, 3);
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
    return Done{};
  } catch (const std::exception& reason) {
    return failure(path_, reason);
  }
}

}  // namespace unietp
