#include <cstdio>
#include <functional>
#include <map>
#include <memory>

#include "cli/command_parser.h"
#include "cli/command_scene.h"
#include "core/files.h"
#include "core/unknown_name.h"
#include "dataset/configuration.h"
#include "interchange/formats.h"
#include "scene/scene_json.h"

namespace unietp {
namespace {

struct SceneExportOptions {
  std::string format;
  std::filesystem::path scene, out;
};

using SceneWriter = std::function<Result<ExportedScene>(const Scene&, const Knowledge&, const FormatFacts&)>;

Result<SceneWriter> writer_named(const std::string& format) {
  const auto plain = [](auto write) {
    return
        [write](const Scene& scene, const Knowledge& knowledge, const FormatFacts&) { return write(scene, knowledge); };
  };
  const auto house = [](const Scene& scene, const Knowledge& knowledge, const FormatFacts& facts) {
    return write_procthor(scene, knowledge, facts);
  };
  const std::map<std::string, SceneWriter> writers{{"behavior", plain(write_behavior)},
                                                   {"habitat", plain(write_habitat)},
                                                   {"procthor", house},
                                                   {"virtualhome", write_virtualhome}};
  if (const auto found = writers.find(format); found != writers.end()) return found->second;
  std::vector<std::string> names;
  names.reserve(writers.size());
  for (const auto& [name, writer] : writers) names.push_back(name);
  return unknown_name_error("format", format, names);
}

Exit write_out(const SceneExportOptions& options, const CommandLine& program) {
  const auto writer = writer_named(options.format);
  if (!writer) return refuse(writer.error());
  const auto text = read_maybe_gzip(options.scene);
  if (!text) return refuse(text.error());
  const auto scene = scene_from_json(options.scene.string(), *text);
  if (!scene) return refuse(scene.error());
  const auto known = load_backends(program.folders);
  if (!known.errors.empty()) return refuse(known.errors);
  const auto [facts, wrong] = read_format_facts(program.folders.scene_files());
  if (!wrong.empty()) return refuse(wrong);
  const auto exported = (*writer)(*scene, known.backends[static_cast<std::size_t>(scene->simulator)].knowledge, facts);
  if (!exported) return refuse(exported.error());
  const bool packed = options.out.extension() == ".gz";
  const auto written = write_file(options.out, packed ? gzip(exported->text) : exported->text);
  if (!written) return refuse(written.error());
  for (const auto& left_out : exported->left_out) (void)std::fprintf(stderr, "left out: %s\n", left_out.c_str());
  return Exit::Ok;
}

}  // namespace

void add_scene_export_command(CommandParser& group, CommandLine& program) {
  auto options = std::make_shared<SceneExportOptions>();  // shared: the callback outlives this function
  auto* command = group.add_subcommand("export", "Write a home as a file that a simulator loads");
  command->explain(
      "What the format cannot express, and objects without a fitting model, are listed on stderr. A file "
      "name that ends in .gz is compressed.",
      {{"unietp scene export procthor home.scene.json.gz --out house.json",
        "a house for AI2-THOR's CreateHouse, with models whose boxes fit"},
       {"unietp scene export virtualhome home.scene.json.gz --out graph.json", "an environment graph"},
       {"unietp scene export habitat home.scene.json.gz --out home.scene_instance.json", ""},
       {"unietp scene export behavior home.scene.json.gz --out home_best.json", "a scene for OmniGibson"}});
  command->add_option("FORMAT", options->format, "Format to write")
      ->required()
      ->suggests({"procthor", "virtualhome", "habitat", "behavior"});
  command->add_option("SCENE", options->scene, "A scene file (.scene.json or .scene.json.gz)")->required();
  command->add_option("--out", options->out, "File to write")->required()->output();
  command->callback([options, &program] { program.exit = write_out(*options, program); });
}

}  // namespace unietp
