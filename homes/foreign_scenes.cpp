#include "homes/foreign_scenes.h"

#include <algorithm>
#include <map>
#include <set>

#include "core/files.h"
#include "core/plain_name.h"
#include "core/text.h"
#include "core/unknown_name.h"
#include "interchange/formats.h"
#include "interchange/scene_models.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;

/// True when a field of this name stands somewhere in the JSON text.
bool has_field(std::string_view text, std::string_view name) {
  const std::string quoted = '"' + std::string(name) + '"';
  for (auto at = text.find(quoted); at != std::string_view::npos; at = text.find(quoted, at + 1)) {
    const auto next = text.find_first_not_of(" \t\r\n", at + quoted.size());
    if (next != std::string_view::npos && text[next] == ':') return true;
  }
  return false;
}

/// The table of models that came with the files, read once it is needed.
class GivenModels {
 public:
  explicit GivenModels(fs::path file) : file_(std::move(file)) {}

  Result<SceneModels> of(SceneFormat format) {
    if (file_.empty()) return SceneModels();
    const bool behavior = format == SceneFormat::Behavior;
    auto& models = behavior ? inventory_ : table_;
    if (!models) {
      const auto text = read_maybe_gzip(file_);
      if (!text) return text.error();
      models = behavior ? read_behavior_inventory(file_.string(), *text) : read_scene_models(file_.string(), *text);
    }
    return *models;
  }

 private:
  fs::path file_;
  std::optional<Result<SceneModels>> table_, inventory_;
};

Result<std::vector<SourceScene>> read_as(SceneFormat format, const std::string& where, std::string_view text,
                                         const std::vector<Backend>& backends, const FormatFacts& facts,
                                         GivenModels& given) {
  const auto known = [&](Simulator simulator) -> const Knowledge& {
    return backends[static_cast<std::size_t>(simulator)].knowledge;
  };
  if (format == SceneFormat::Ithor) return read_ithor(where, text);
  if (format == SceneFormat::Procthor) return read_procthor(where, text, known(Simulator::Ai2thor));
  if (format == SceneFormat::Virtualhome) return read_virtualhome(where, text, known(Simulator::Virtualhome), facts);
  const auto models = given.of(format);
  if (!models) return models.error();
  if (format == SceneFormat::Behavior) return read_behavior(where, text, known(Simulator::Behavior), *models);
  return read_habitat(where, text, known(Simulator::Habitat), facts, *models);
}

/// The plain name nearest to an id.
std::string as_file_name(const std::string& id) {
  constexpr std::size_t kLongest = 100;
  std::string name;
  for (const char c : id) {
    name += c;
    if (!is_plain_name(name)) name.back() = '_';
    if (name.size() == kLongest) break;
  }
  return name.empty() ? "home" : name;
}

class FreshNames {
 public:
  std::string take(const std::string& id) {
    const std::string name = as_file_name(id);
    std::string fresh = name;
    for (int& n = last_.try_emplace(lower(name), 1).first->second; !taken_.insert(lower(fresh)).second;)
      fresh = name + "-" + std::to_string(++n);
    return fresh;
  }

 private:
  // In lower case: some file systems do not tell the cases apart.
  std::set<std::string> taken_;
  std::map<std::string, int> last_;  // number behind a name, so that a file of equal ids is read in linear time
};

/// The format that was asked for, or else the file's own.
Result<SceneFormat> format_for(std::optional<SceneFormat> asked, const std::string& where, std::string_view text) {
  if (asked) return *asked;
  if (auto found = scene_format_of(text)) return *found;
  return Error{
      Error::Kind::Usage, where, {}, "has an unknown format; accepted are " + join(scene_format_names(), ", ")};
}

}  // namespace

std::optional<SceneFormat> scene_format_of(std::string_view text) {
  const auto any = [&](std::initializer_list<std::string_view> names) {
    return std::any_of(names.begin(), names.end(), [&](std::string_view name) { return has_field(text, name); });
  };
  if (any({"floorPolygon"})) return SceneFormat::Procthor;
  if (any({"object_instances", "articulated_object_instances", "stage_instance"}))
    return text.find("frl_apartment") != std::string_view::npos ? SceneFormat::Replicacad : SceneFormat::Hssd;
  if (any({"objects_info", "ori_xyzw", "fixed_base"})) return SceneFormat::Behavior;
  if (any({"class_name"})) return SceneFormat::Virtualhome;
  if (any({"objectId"})) return SceneFormat::Ithor;
  if (any({"center"}) && any({"size"})) return SceneFormat::Hssd;  // labeled boxes
  return std::nullopt;
}

ForeignReading read_foreign_scenes(const std::string& format, const std::vector<fs::path>& files,
                                   const std::vector<Backend>& backends, const FormatFacts& facts,
                                   const fs::path& models) {
  ForeignReading reading;
  const auto asked = scene_format_named(format);
  if (!asked && format != "auto") {
    auto accepted = scene_format_names();
    accepted.insert(accepted.begin(), "auto");
    reading.errors.push_back(unknown_name_error("format", format, accepted));
    return reading;
  }
  FreshNames names;
  GivenModels given(models);
  for (const auto& file : files) {
    const auto text = read_maybe_gzip(file);
    if (!text) {
      reading.errors.push_back(text.error());
      continue;
    }
    const auto is = format_for(asked, file.string(), *text);
    if (!is) {
      reading.errors.push_back(is.error());
      continue;
    }
    auto homes = read_as(*is, file.string(), *text, backends, facts, given);
    if (!homes) {
      reading.errors.push_back(homes.error());
      continue;
    }
    if (homes->empty()) reading.errors.push_back({Error::Kind::Usage, file.string(), {}, "contains no home"});
    for (auto& home : *homes) {
      home.id = names.take(home.id);
      reading.homes.push_back({file, *is, std::move(home)});
    }
  }
  return reading;
}

Result<ImportedScene> import_home(const ForeignHome& home, const std::vector<Backend>& backends,
                                  const FormatFacts& facts, const ImportOptions& options) {
  const auto& backend = backends[static_cast<std::size_t>(home.source.simulator)];
  return assemble(home.source, backend.knowledge, backend.profile, facts, options);
}

}  // namespace unietp
