#include <nanobind/nanobind.h>
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <nlohmann/json.hpp>

#include "core/files.h"
#include "python/native/bindings.h"
#include "python/native/failure.h"
#include "python/native/json_to_python.h"
#include "record/dataset_lines.h"
#include "record/home_cache.h"
#include "record/line_index.h"
#include "record/manifest_record.h"
#include "record/record_fields.h"
#include "record/task_record.h"
#include "scene/json_parse.h"
#include "scene/scene_json.h"

namespace nb = nanobind;
using namespace nb::literals;

namespace unietp::python {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// Tasks or demonstrations, by their position in the file.
struct RecordLines {
  LineIndex index;
  Result<Done> (*check)(std::string_view file, int line, std::string_view text);  // what the program reads it with
};

template <auto kRead>
Result<Done> is_read_by(std::string_view file, int line, std::string_view text) {
  const auto record = kRead(file, line, text);
  return record ? Result<Done>(Done{}) : Result<Done>(record.error());
}

RecordLines open_tasks(const fs::path& folder) {
  return {value_of(LineIndex::open(folder, kTasksFile, FileNames::WithFolder)), &is_read_by<&read_task>};
}

RecordLines open_demonstrations(const fs::path& folder, const std::string& mode) {
  const auto known = mode_named(mode);
  if (!known) throw PythonError("no mode is named " + in_quotes(mode));
  return {value_of(LineIndex::open(folder, demonstrations_file(*known), FileNames::WithFolder)),
          &is_read_by<&read_demonstration>};
}

nb::object line_at(const RecordLines& lines, std::size_t position) {
  if (position >= lines.index.size()) throw nb::index_error();
  const auto json = [&] {
    const nb::gil_scoped_release others_run;
    const auto line = value_of(lines.index.line(position));
    value_of(lines.check(lines.index.name(), line.number, line.text));
    return value_of(parse_json_line(lines.index.name(), line.number, line.text));
  }();
  return to_python(json);
}

nb::object home(const fs::path& folder, const std::string& layout) {
  const auto json = [&] {
    const nb::gil_scoped_release others_run;
    const auto file = home_file(layout), where = (folder / file).string();
    const auto text = value_of(read_maybe_gzip(folder, file));
    const auto scene = value_of(scene_from_json(where, text));
    if (scene.id != layout)
      throw PythonError(where + ": is called " + in_quotes(scene.id) + ", not " + in_quotes(layout));
    return value_of(parse_json(where, text));
  }();
  return to_python(json);
}

nb::object manifest(const fs::path& folder) {
  const auto json = [&] {
    const nb::gil_scoped_release others_run;
    return value_of(parse_json((folder / kManifest).string(), value_of(read_file(folder, kManifest))));
  }();
  return to_python(json);
}

}  // namespace

void define_data_files(nb::module_& module) {
  nb::class_<RecordLines>(
      module, "RecordLines",
      "The lines of a data set's file. Only their places are kept in memory. May be used by several "
      "threads.")
      .def_static("tasks", &open_tasks, "folder"_a, nb::call_guard<nb::gil_scoped_release>(),
                  "Of tasks.jsonl. Raises Error for a file that is missing, no regular file, or has a line that is cut "
                  "off or too long.")
      .def_static("demonstrations", &open_demonstrations, "folder"_a, "mode"_a,
                  nb::call_guard<nb::gil_scoped_release>(), "Of demonstrations/<mode>.jsonl, likewise.")
      .def_prop_ro(
          "name", [](const RecordLines& lines) { return lines.index.name(); }, "The file, for messages.")
      .def("__len__", [](const RecordLines& lines) { return lines.index.size(); })
      .def(
          "line", &line_at, "position"_a,
          "The object in a line, counted from 0. Raises Error with file and line where the program would not read it.");
  module.def("home", &home, "folder"_a, "layout"_a,
             "The scene graph of a home in a data set's folder. Raises Error for a file that is not as it should be.");
  module.def("manifest", &manifest, "folder"_a, "manifest.json of a data set. Raises Error, likewise.");
  module.def(
      "shown_modes",
      [](const fs::path& folder) {
        std::vector<std::string> names;
        for (const auto mode : shown_modes(folder)) names.emplace_back(name_of(mode));
        return names;
      },
      "folder"_a, "The modes that a data set has demonstrations of.");
}

}  // namespace unietp::python
