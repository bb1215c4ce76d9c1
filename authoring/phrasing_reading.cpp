#include "authoring/phrasing_reading.h"

#include <algorithm>
#include <optional>

#include "annotator/authored.h"
#include "annotator/home_facts.h"
#include "annotator/instruction.h"
#include "annotator/other_wordings.h"
#include "core/text.h"
#include "generator/style_fit.h"
#include "scene/trace.h"

namespace unietp {
namespace {

constexpr std::uint64_t kBindings = 6;  // of each simulator
constexpr std::uint64_t kDraws = 3;     // ways to name the things of each
constexpr std::uint64_t kSeeds = 24;    // texts that are drawn for a style

/// Tasks of the template on the simulators that it claims.
std::vector<Specification> sample_tasks(const Template& source, const std::vector<Backend>& backends) {
  std::vector<Specification> tasks;
  for (const Simulator simulator : source.simulators) {
    const Knowledge& knowledge = backends[static_cast<std::size_t>(simulator)].knowledge;
    for (std::uint64_t i = 0; i < kBindings; ++i) {
      const auto binding = sample_binding(source, knowledge, {}, Rng(0).fork("phrasing", i));
      auto made = binding ? instantiate(source, knowledge, *binding)
                          : Result<Specification>(Error{Error::Kind::Unsatisfiable, "", {}, ""});
      if (made) tasks.push_back(std::move(*made));
    }
  }
  return tasks;
}

PhrasingReading reading_of(const std::string& phrasing, const std::vector<Specification>& tasks,
                           const std::vector<Backend>& backends) {
  PhrasingReading reading;
  for (const Specification& task : tasks) {
    const Backend& backend = backends[static_cast<std::size_t>(task.simulator)];
    for (std::uint64_t draw = 0; draw < kDraws; ++draw) {
      const auto text = authored_text(phrasing, task, backend.nouns, {task.style}, {}, Rng(draw));
      if (!text) continue;
      const auto faults = check_instruction(*text, task, backend.knowledge, backend.nouns);
      reading = {faults.empty(), *text, join(faults, "; ")};
      if (reading.readable) return reading;
    }
  }
  if (reading.text.empty()) reading.why = "its slots do not fit what the goal says of them";
  return reading;
}

}  // namespace

std::vector<PhrasingReading> read_phrasings(const Template& source, const std::vector<Backend>& backends) {
  const auto tasks = sample_tasks(source, backends);
  std::vector<PhrasingReading> readings;
  for (const std::string& phrasing : source.instructions) readings.push_back(reading_of(phrasing, tasks, backends));
  return readings;
}

std::vector<StyleTexts> texts_by_style(const Template& source, const Specification& plain, const Backend& backend,
                                       const Scene& home, std::size_t count, Rng rng) {
  std::vector<Style> styles = styles_fitting(source);
  styles.push_back(plain.style);
  std::sort(styles.begin(), styles.end());
  styles.erase(std::unique(styles.begin(), styles.end()), styles.end());
  const SceneOffer offer{categories_in(home), to_logic(home, {}, true), nullptr};
  WritingOptions writing;
  writing.phrasings_of_template = source.instructions;
  writing.home = &home;
  writing.around = offer.categories;
  std::vector<StyleTexts> all;
  for (const Style style : styles) {
    StyleTexts found{style, {}};
    std::vector<std::pair<Specification, Instruction>> plainly;
    for (std::uint64_t seed = 0; seed < kSeeds && found.texts.size() < count; ++seed) {
      const Rng own = rng.fork(name_of(style), seed);
      const auto task = style == plain.style
                            ? std::optional(plain)
                            : refine_linguistic(plain, backend.knowledge, offer, name_of(style), own.fork("goal", 0));
      if (!task) continue;
      const auto text = write_instruction(*task, backend.knowledge, backend.nouns, writing, own);
      if (!text || text->style != style) continue;
      if (std::find(found.texts.begin(), found.texts.end(), text->text) != found.texts.end()) continue;
      found.texts.push_back(text->text);
      plainly.emplace_back(*task, *text);
    }
    for (const auto& [task, text] : plainly)  // where a style has few texts, the same as requests
      for (const Instruction& request :
           requests_for(text, task, backend.knowledge, backend.nouns, home, {found.texts.begin(), found.texts.end()},
                        count - found.texts.size()))
        found.texts.push_back(request.text);
    if (!found.texts.empty()) all.push_back(std::move(found));
  }
  return all;
}

}  // namespace unietp
