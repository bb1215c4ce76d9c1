#include "authoring/phrasing_reading.h"

#include <algorithm>
#include <map>
#include <optional>

#include "annotator/authored.h"
#include "annotator/home_counts.h"
#include "annotator/home_facts.h"
#include "annotator/instruction.h"
#include "annotator/other_wordings.h"
#include "core/sort_unique.h"
#include "core/text.h"
#include "generator/style_fit.h"
#include "scene/trace.h"

namespace unietp {
namespace {

constexpr std::uint64_t kBindings = 6;  // of each simulator
constexpr std::uint64_t kDraws = 3;     // ways to name the things of each
constexpr int kMostCarried = 3;         // things of a category that a sample home has
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

using Op = Formula::Op;
using Categories = std::map<std::string, std::string, std::less<>>;  // by variable

/// A home for reading: a few things of each category, about which is so what the task says of its start.
class SampleHome {
 public:
  SampleHome(const Specification& task, const Knowledge& knowledge, int carried) {
    std::vector<std::string> categories = categories_of(task.goal);
    for (const Formula& part : task.init)
      for (std::string& category : categories_of(part)) categories.push_back(std::move(category));
    sort_unique(categories);
    for (const std::string& category : categories) {
      const Category* known = knowledge.find(category);
      if (known == nullptr) {
        home_.rooms.push_back({category + "_1", category, {}});
        continue;
      }
      for (int i = 1; i <= (known->movable ? carried : 1); ++i) {
        Node node;
        node.id = category + "_" + std::to_string(i);
        node.category = category;
        node.movable = known->movable;
        nodes_.push_back(std::move(node));
      }
    }
    for (const Formula& part : task.init) state(part, {}, true);
    describe(task.goal, {});
    for (Node& node : nodes_) home_.nodes.push_back(std::move(node));
  }

  const Scene& home() const { return home_; }

 private:
  static std::string category_of(const Formula& binder) {
    return binder.domain.members.empty() ? "" : binder.domain.members[0].category;
  }

  /// What describes the things of the goal: of all of them where it is about all, of the first one otherwise.
  void describe(const Formula& part, Categories bound) {
    if (!part.variable.empty()) {
      bound[part.variable] = category_of(part);
      for (const Formula& where : part.domain.where) state(where, bound, part.op == Op::Forall);
    }
    for (const Formula& child : part.children) describe(child, bound);
  }

  void state(const Formula& part, Categories bound, bool of_all) {
    if (part.op == Op::Not || part.op == Op::Or || part.op == Op::Imply) return;
    if (part.op == Op::Count && (part.number == 0 || part.comparison == Comparison::AtMost)) return;
    if (!part.variable.empty()) bound[part.variable] = category_of(part);
    if (part.op == Op::Atom) note(part, bound, of_all);
    for (const Formula& child : part.children) state(child, bound, of_all);
  }

  void note(const Formula& atom, const Categories& bound, bool of_all) {
    const auto category = [&](const Term& term) {
      const auto found = bound.find(term.name);
      return term.kind == Term::Kind::Variable && found != bound.end() ? found->second : std::string();
    };
    const std::string own = category(atom.terms[0]);
    for (Node& node : nodes_) {
      if (node.category != own || (!of_all && node.id != own + "_1")) continue;
      if (atom.terms.size() == 1) {
        node.states.set({atom.predicate, ""});
      } else if (atom.predicate == Predicate::Color || atom.predicate == Predicate::Material) {
        (atom.predicate == Predicate::Color ? node.color : node.material) = atom.terms[1].name;
      } else if (const std::string other = category(atom.terms[1]); !other.empty()) {
        home_.edges.insert({atom.predicate, node.id, other + "_1"});
      }
    }
  }

  std::vector<Node> nodes_;
  Scene home_;
};

/// Of texts about no home in particular, about one with one thing of each category, with two, and with three.
PhrasingReading reading_of(const std::string& phrasing, const std::vector<Specification>& tasks,
                           const std::vector<Backend>& backends) {
  PhrasingReading reading;
  for (const Specification& task : tasks) {
    const Backend& backend = backends[static_cast<std::size_t>(task.simulator)];
    for (int carried = 0; carried <= kMostCarried; ++carried) {
      const SampleHome sample(task, backend.knowledge, carried);
      const Scene* home = carried == 0 ? nullptr : &sample.home();
      const Trace start = home == nullptr ? Trace() : to_logic(*home, {}, true);
      const auto alone = home == nullptr ? std::vector<std::string>() : alone_in(*home);
      const auto there = home == nullptr ? std::vector<std::string>() : categories_in(*home);
      const HomeCounts counts = home == nullptr ? HomeCounts() : HomeCounts(start);
      for (std::uint64_t draw = 0; draw < kDraws; ++draw) {
        const auto text =
            authored_text(phrasing, task, backend.nouns, {task.style, true, alone, there}, counts, Rng(draw));
        if (!text) continue;
        const auto faults = check_instruction(*text, task, backend.knowledge, backend.nouns, home);
        if (carried == 0 || reading.text.empty() || faults.empty())
          reading = {faults.empty(), *text, join(faults, "; ")};
        if (reading.readable) return reading;
      }
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
