#include "akb/knowledge.h"
#include "bodies.h"
#include "fuzz_bodies.h"
#include "llm/cache.h"
#include "support.h"
#include "templates/template_files.h"

namespace unietp::fuzz {
bool knowledge_body(std::string_view bytes) {
  static const Folder folder("knowledge");
  folder.write("k.sqlite", bytes);
  const auto file = folder.path() / "k.sqlite";
  if (!check_result(digest_of_database(file))) return false;
  bool all = true;
  for (const Simulator simulator : kSimulators) {
    const auto knowledge = load_knowledge(file, simulator);
    all = check_result(knowledge) && all;
    if (!knowledge) continue;
    for (const Category& category : knowledge->categories()) {
      const Category* found = knowledge->find(category.name);
      require(found != nullptr && found->name == category.name);
      for (const Placement* placement : knowledge->placements_of(category.name, Predicate::On))
        require(placement->object == category.name);
    }
  }
  return all;
}

bool library_body(std::string_view bytes) {
  static const Folder folder("library");
  folder.write("k.sqlite", bytes);
  const auto files = stored_templates(folder.path() / "k.sqlite", "/templates");
  if (!check_result(files)) return false;
  const TemplateReading reading = parse_files(*files);
  for (const Error& error : reading.errors) check_error(error);
  require(reading.templates.size() <= files->size());
  return reading.errors.empty();
}

bool cache_body(std::string_view bytes) {
  static const Folder folder("cache");
  for (const char* name : {"llm.sqlite-wal", "llm.sqlite-shm"}) std::filesystem::remove(folder.path() / name);
  folder.write("llm.sqlite", bytes);
  auto cache = LlmCache::open(folder.path() / "llm.sqlite");
  if (!check_result(cache)) return false;
  const auto known = cache->find("known");
  const LlmAnswer answer{"{\"a\": 1}", 3, 4, 1, false};
  cache->store("new", "fuzz", answer);
  const auto stored = cache->find("new");
  if (cache->failure()) {
    check_error(*cache->failure());
    return false;
  }
  require(stored && stored->cached);
  return known.has_value();
}

}  // namespace unietp::fuzz
