#include <set>

#include "bodies.h"
#include "fuzz_bodies.h"
#include "homes/foreign_scenes.h"
#include "interchange/format_facts.h"
#include "support.h"

namespace unietp::fuzz {
namespace {

std::vector<Backend> small_backends() {
  std::vector<Backend> backends;
  for (const Simulator simulator : kSimulators) {
    Category mug;
    mug.name = mug.display = "Mug";
    mug.plural = "Mugs";
    mug.movable = true;
    mug.size = {0.1, 0.1, 0.1};
    mug.mass = 0.3;
    Knowledge knowledge(simulator, {mug}, {}, {}, {}, {});
    NounTable nouns(knowledge, {});
    backends.push_back({std::move(knowledge), Profile{}, std::move(nouns)});
  }
  return backends;
}

}  // namespace

bool foreign_body(std::string_view text) {
  static const Folder folder("foreign");
  static const std::vector<Backend> backends = small_backends();
  folder.write("homes.json", text);
  const auto file = folder.path() / "homes.json";
  static const FormatFacts facts{{{"sofa", "Mug"}}, {{"Doorframe_1", 1, 2.1}}, {}};
  const ForeignReading reading = read_foreign_scenes("auto", {file, file}, backends, facts);
  for (const Error& error : reading.errors) check_error(error);
  std::set<std::string> ids;
  for (const ForeignHome& home : reading.homes) {
    require(!home.source.id.empty() && home.source.id.front() != '.');
    require(home.source.id.find('/') == std::string::npos && ids.insert(home.source.id).second);
  }
  return reading.errors.empty();
}

}  // namespace unietp::fuzz
