#include "python/native/catalog.h"

#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <algorithm>

#include "akb/table_words.h"
#include "core/in_quotes.h"
#include "dataset/configuration.h"
#include "procedural/simulator_data.h"
#include "python/native/bindings.h"
#include "python/native/episode_tasks.h"
#include "python/native/failure.h"
#include "record/manifest_record.h"
#include "resources/find_data_folder.h"
#include "resources/resources.h"

namespace nb = nanobind;
using namespace nb::literals;

namespace unietp::python {
namespace {

std::shared_ptr<Catalog> load_catalog(const DataFolders& folders) {
  auto reading = load_resources(folders);
  raise_any(reading.errors);
  auto resources = std::make_shared<const Resources>(std::move(reading.resources));
  auto names = room_types();
  for (const auto& backend : resources->backends) {
    for (const auto& category : backend.knowledge.categories()) names.push_back(category.name);
  }
  std::ranges::sort(names);
  names.erase(std::unique(names.begin(), names.end()), names.end());
  auto simulators = simulator_data(resources);
  return std::make_shared<Catalog>(Catalog{std::move(resources), std::move(simulators), Vocabulary(std::move(names))});
}

const Profile& profile_of(const Catalog& catalog, const std::string& simulator) {
  const auto found = simulator_named(simulator);
  if (!found) throw PythonError("no simulator is named " + in_quotes(simulator));
  return *catalog.simulators[static_cast<std::size_t>(*found)].profile;
}

/// The values of these names. Raises for a name of none.
template <class Value>
std::vector<Value> named(const std::vector<std::string>& names, std::optional<Value> (*find)(std::string_view),
                         const char* kind) {
  std::vector<Value> values;
  for (const auto& name : names) {
    const auto value = find(name);
    if (!value) throw PythonError("no " + std::string(kind) + " is named " + in_quotes(name));
    values.push_back(*value);
  }
  return values;
}

EpisodeTasks procedural(const Catalog& catalog, const std::vector<std::string>& simulators,
                        const std::vector<std::string>& splits, const std::vector<std::string>& templates,
                        const std::vector<std::string>& modes, const std::string& sense, int homes,
                        std::uint64_t homes_seed, int attempts) {
  return {value_of(Procedural::make(
      catalog.resources,
      {named(simulators, simulator_named, "simulator"), named(splits, split_named, "split"), templates,
       named(modes, mode_named, "mode"), value_of(parse_sense("sense", sense)), homes, homes_seed, attempts}))};
}

nb::dict listing_row(const TaskListing& row) {
  nb::dict dict;
  dict["id"] = row.id;
  dict["split"] = row.split;
  dict["template"] = row.template_name;
  dict["simulator"] = row.simulator;
  dict["layout"] = row.layout;
  dict["instruction"] = row.instruction;
  return dict;
}

nb::list listing(const EpisodeTasks& tasks) {
  nb::list rows;
  if (const auto* source = std::get_if<TaskSource>(&tasks.from)) {
    for (const auto& row : source->listing()) rows.append(listing_row(row));
  }
  return rows;
}

void define_knowledge(nb::module_& module) {
  nb::class_<Catalog>(module, "Catalog", "Knowledge and profiles of the four simulators. Immutable.")
      .def_static(
          "load",
          [](const std::filesystem::path& data, const std::filesystem::path& cache, bool extended) {
            return load_catalog({data, cache, {}, {}, extended});
          },
          "data"_a, "cache"_a, "extended"_a = false, nb::call_guard<nb::gil_scoped_release>(),
          "Reads the folder that holds data/ and templates/; compiles the tables into `cache` where it has no "
          "compiled/.\n"
          "Raises Error for a file that is missing or wrong.")
      .def_prop_ro(
          "categories", [](const Catalog& catalog) { return catalog.vocabulary.names(); },
          "Names of all categories and room types, sorted. In arrays a name is its position + 1; 0 is none of them.")
      .def(
          "image_size",
          [](const Catalog& catalog, const std::string& simulator) {
            const auto& profile = profile_of(catalog, simulator);
            return std::pair(profile.image_width, profile.image_height);
          },
          "simulator"_a, "Width and height in pixels of what the simulator's camera shows.");
}

void define_tasks(nb::module_& module) {
  nb::class_<TaskHandle>(module, "Task", "A task that is ready to be acted in. Immutable, shared.")
      .def_prop_ro("id", [](const TaskHandle& handle) { return handle.task->text.id; })
      .def_prop_ro("instruction", [](const TaskHandle& handle) { return handle.task->text.instruction; })
      .def_prop_ro("split", [](const TaskHandle& handle) { return handle.task->text.split; })
      .def_prop_ro("template_name", [](const TaskHandle& handle) { return handle.task->text.template_name; })
      .def_prop_ro("layout", [](const TaskHandle& handle) { return handle.task->text.layout; })
      .def_prop_ro("simulator", [](const TaskHandle& handle) { return std::string(name_of(handle.task->simulator)); })
      .def_prop_ro(
          "objects", [](const TaskHandle& handle) { return handle.task->start.nodes.size(); },
          "Number of objects in the home at the start.");

  nb::class_<EpisodeTasks>(module, "EpisodeTasks", "Where tasks come from. May be used by several threads.")
      .def_static(
          "open",
          [](const std::filesystem::path& folder, const Catalog& catalog, std::size_t homes, std::size_t tasks) {
            return EpisodeTasks{value_of(TaskSource::open(folder, catalog.simulators, {homes, tasks}))};
          },
          "folder"_a, "catalog"_a, "homes"_a = TaskSource::Kept().homes, "tasks"_a = TaskSource::Kept().tasks,
          nb::call_guard<nb::gil_scoped_release>(),
          "The tasks of a data set. `homes`, `tasks`: how many are kept in memory once they were asked for.\n"
          "Raises Error for a folder without tasks and for a line that is not as it should be.")
      .def_static(
          "procedural", &procedural, "catalog"_a, "simulators"_a, "splits"_a, "templates"_a, "modes"_a, "sense"_a,
          "homes"_a, "homes_seed"_a, "attempts"_a, nb::call_guard<nb::gil_scoped_release>(),
          "New tasks without end. Empty lists of splits and templates: all. `sense`: as of `unietp generate --sense`.\n"
          "`homes`: of each simulator, kept in\n"
          "memory. Raises Error for unknown names and numbers out of range.")
      .def("listing", &listing,
           "id, split, template, simulator, layout and instruction of each task, in the order of the file; empty for\n"
           "new tasks.")
      .def(
          "task_of_episode",
          [](const EpisodeTasks& tasks, std::optional<std::uint64_t> seed, std::uint64_t episode) {
            return TaskHandle{value_of(tasks.task_of_episode(seed, episode))};
          },
          "seed"_a.none(), "episode"_a, nb::call_guard<nb::gil_scoped_release>(),
          "The task of an episode: in the order of the file, or in the order of a seed. Raises Error when it cannot "
          "be\n"
          "made or its files are wrong.")
      .def(
          "task",
          [](const EpisodeTasks& tasks, std::uint64_t number) {
            return TaskHandle{value_of(tasks.task_of_episode(std::nullopt, number))};
          },
          "number"_a, nb::call_guard<nb::gil_scoped_release>(),
          "The task at a position of the file, or the new task of a seed.");
}

void define_encoding(nb::module_& module) {
  nb::class_<Encoding>(module, "Encoding", "How observations become arrays and actions numbers.")
      .def(
          "__init__",
          [](Encoding* self, std::shared_ptr<Catalog> catalog, std::vector<std::string> actions, std::size_t rows,
             std::size_t text_bytes) {
            new (self) Encoding{std::move(catalog), std::move(actions), rows, text_bytes};
          },
          "catalog"_a, "actions"_a, "rows"_a, "text_bytes"_a)
      .def_ro("actions", &Encoding::actions)
      .def_ro("rows", &Encoding::rows);
}

}  // namespace

void define_catalog(nb::module_& module) {
  define_knowledge(module);
  define_tasks(module);
  define_encoding(module);
  module.def(
      "find_data_folder",
      [](const std::filesystem::path& program, const std::string& variable) {
        return value_of(find_data_folder(program, variable));
      },
      "program"_a, "variable"_a, "The folder with the data that a program at this place uses. Raises Error for none.");
  module.def("records_extended_library", &records_extended_library, "folder"_a,
             "Whether a data set was made with the extended library, and its agents have the profile `wide`.");
}

}  // namespace unietp::python
