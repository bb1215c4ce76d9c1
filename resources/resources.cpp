#include "resources/resources.h"

#include <unistd.h>

#include <algorithm>
#include <set>

#include "core/digest.h"
#include "core/files.h"
#include "core/text.h"
#include "core/version.h"
#include "resources/template_library.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;

Error io_error(const fs::path& path, std::string message) {
  return {Error::Kind::Io, path.string(), {}, std::move(message)};
}

/// Files below a folder in order of path.
Result<std::vector<fs::path>> files_below(const fs::path& folder) {
  std::error_code code;
  std::vector<fs::path> files;
  auto it = fs::recursive_directory_iterator(folder, code);
  if (code) return io_error(folder, "cannot list this folder: " + code.message());
  for (; it != fs::recursive_directory_iterator(); it.increment(code)) {
    if (code) return io_error(folder, "cannot list this folder: " + code.message());
    if (it->is_regular_file(code)) files.push_back(it->path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

bool is_placeholder(const Template& source, const std::string& name) {
  return std::any_of(source.parameters.begin(), source.parameters.end(),
                     [&](const Parameter& parameter) { return parameter.name == name; });
}

bool is_word_byte(char c) {
  return c != ' ' && c != '\n' && c != '\t' && c != '(' && c != ')' && c != '/' && c != '\r';
}

/// Where a name first stands as a word of its own in a file; {0, 0} when it does not.
SourcePos place_of(const fs::path& file, const std::string& name) {
  const auto text = read_file(file);
  if (!text) return {};
  for (std::size_t at = text->find(name); at != std::string::npos; at = text->find(name, at + 1)) {
    const std::size_t end = at + name.size();
    if ((at == 0 || !is_word_byte((*text)[at - 1])) && (end == text->size() || !is_word_byte((*text)[end])))
      return locate(*text, at);
  }
  return {};
}

/// What a database is compiled from.
struct KnowledgeInputs {
  std::string tables;  // digest of tables and overrides
  TemplateFiles templates;
  std::string file_name;
};

struct InputsReading {
  KnowledgeInputs inputs;
  std::vector<Error> errors;
};

InputsReading read_inputs(const DataFolders& folders) {
  const auto tables = digest_of_tables(folders.tables(), folders.overrides);
  if (!tables) return {{}, {tables.error()}};
  auto templates = built_in_templates(folders);
  if (!templates.errors.empty()) return {{}, std::move(templates.errors)};
  const auto digest = sha256(*tables + digest_of(templates.files, folders.root));
  // The number of the format is part of the name, so that a newer program never reads an older one's file. The name
  // also vouches for the templates, since a file is renamed into place only when it is complete.
  return {{*tables, std::move(templates), "knowledge-6-" + digest.substr(0, 32) + ".sqlite"}, {}};
}

/// Where tables of the data folder do not read, adds what to do: they may have come with another version.
std::vector<Error> with_advice(const DataFolders& folders, std::vector<Error> errors) {
  const std::string data = (folders.root / "data").string();
  const bool unread = std::any_of(errors.begin(), errors.end(), [&](const Error& error) {
    return (error.kind == Error::Kind::Parse || error.kind == Error::Kind::Schema) &&
           error.where.starts_with(data + "/");
  });
  const bool reported =
      std::any_of(errors.begin(), errors.end(), [&](const Error& error) { return error.where == data; });
  if (unread && !reported) {
    errors.push_back({Error::Kind::Usage,
                      data,
                      {},
                      "unietp " + std::string(program_version()) + " (" + std::string(program_build()) +
                          ") cannot read these tables; if they came with another version, use that version, or give "
                          "this one its own data with --data or UNIETP_DATA"});
  }
  return errors;
}

CompiledKnowledge compile_inputs(const fs::path& folder, const DataFolders& folders, const KnowledgeInputs& inputs) {
  std::error_code code;
  fs::create_directories(folder, code);
  if (code) return {{}, {io_error(folder, "cannot make this folder for compiled knowledge: " + code.message())}};
  const fs::path database = folder / inputs.file_name;
  auto partial = database;
  partial += "." + std::to_string(::getpid()) + ".tmp";  // of each process its own; a killed one may leave it
  auto errors = compile_knowledge(folders.tables(), partial, folders.overrides);
  if (!errors.empty()) return {{}, with_advice(folders, std::move(errors))};
  if (const auto put = store_templates(partial, folders.root, inputs.templates.files); !put) return {{}, {put.error()}};
  fs::rename(partial, database, code);
  if (code) return {{}, {io_error(database, "cannot rename the compiled knowledge: " + code.message())}};
  return {database, {}};
}

void load_sense(const DataFolders& folders, ResourcesReading& reading) {
  Resources& resources = reading.resources;
  auto common = read_common_sense(folders.sense(), reading.errors);
  auto words = read_word_kinds(folders.sense(), common.kinds(), reading.errors);
  if (!reading.errors.empty()) return;
  resources.sense = std::make_shared<const SenseTables>(SenseTables{std::move(common), std::move(words)});
  for (const auto& backend : resources.backends)
    resources.piece_grades.emplace_back(backend.knowledge, resources.sense);
}

}  // namespace

CompiledKnowledge compiled_knowledge(const DataFolders& folders) {
  auto [inputs, errors] = read_inputs(folders);
  if (!errors.empty()) return {{}, std::move(errors)};
  for (const auto& folder : {folders.compiled(), folders.cache}) {
    const auto stored = digest_of_database(folder / inputs.file_name);
    if (stored && *stored == inputs.tables) return {folder / inputs.file_name, {}};
  }
  return compile_inputs(folders.cache, folders, inputs);
}

CompiledKnowledge compile_knowledge_into(const fs::path& folder, const DataFolders& folders) {
  auto [inputs, errors] = read_inputs(folders);
  if (!errors.empty()) return {{}, std::move(errors)};
  return compile_inputs(folder, folders, inputs);
}

const NounTable& Backend::nouns_in(English english) const {
  if (english == English::Us) return nouns;
  std::call_once(british->made, [&] { british->nouns.emplace(knowledge, nouns.everyday(), English::Gb); });
  return *british->nouns;
}

BackendsReading load_backends(const DataFolders& folders) {
  BackendsReading reading;
  auto compiled = compiled_knowledge(folders);
  reading.errors = std::move(compiled.errors);
  reading.database = std::move(compiled.database);
  const SharedValue<EverydayNames> everyday = read_everyday_names(folders.english(), reading.errors);
  const auto actions = folders.extended_library ? ActionProfile::Wide : ActionProfile::Unietp;
  for (const auto simulator : kSimulators) {
    auto profile = load_profile(folders.profiles(), simulator, actions);
    if (!profile) reading.errors.push_back(profile.error());
    if (!reading.errors.empty()) continue;
    auto knowledge = load_knowledge(reading.database, simulator);
    if (!knowledge) {
      reading.errors.push_back(knowledge.error());
      continue;
    }
    NounTable nouns(*knowledge, everyday);
    reading.backends.push_back({std::move(*knowledge), *profile, std::move(nouns), std::make_shared<BritishNouns>()});
  }
  reading.errors = with_advice(folders, std::move(reading.errors));
  return reading;
}

ResourcesReading load_resources(const DataFolders& folders) {
  ResourcesReading reading;
  auto& resources = reading.resources;
  auto backends = load_backends(folders);
  resources.backends = std::move(backends.backends);
  reading.errors = std::move(backends.errors);

  if (resources.backends.size() != kSimulators.size()) return reading;
  auto library = library_in(backends.database, folders);
  resources.templates = std::move(library.templates);
  resources.own = std::move(library.own);
  reading.errors.insert(reading.errors.end(), library.errors.begin(), library.errors.end());

  for (const auto& source : resources.templates) {
    const auto unknown = unknown_categories(source, resources.backends);
    reading.errors.insert(reading.errors.end(), unknown.begin(), unknown.end());
  }
  for (const auto& backend : resources.backends) {
    auto recipe = load_recipe(folders.layouts(), backend.knowledge);
    if (!recipe) {
      reading.errors.push_back(recipe.error());
    } else {
      resources.recipes.push_back(std::move(*recipe));
    }
  }
  load_sense(folders, reading);
  if (auto benchmark = benchmark_layouts(folders.layouts()); !benchmark) {
    reading.errors.push_back(benchmark.error());
  } else {
    resources.benchmark = std::move(*benchmark);
  }
  if (auto frozen = FrozenBenchmarks::read(folders.benchmarks()); !frozen) {
    reading.errors.push_back(frozen.error());
  } else {
    resources.frozen = std::move(*frozen);
  }
  const auto digest = knowledge_digest(folders);
  if (!digest) {
    reading.errors.push_back(digest.error());
  } else {
    resources.digest = *digest;
  }
  reading.errors = with_advice(folders, std::move(reading.errors));
  return reading;
}

Result<std::string> knowledge_digest(const DataFolders& folders) {
  std::string listing;
  std::vector<fs::path> covered{folders.tables(),  folders.sense(),   folders.profiles(),
                                folders.layouts(), folders.english(), folders.library()};
  for (const auto& folder : {folders.extended(), folders.scene_files(), folders.bddl()}) {
    if (std::error_code code; fs::exists(folder, code)) covered.push_back(folder);
  }
  for (const auto& folder : covered) {
    const auto files = files_below(folder);
    if (!files) return files.error();
    for (const auto& file : *files) {
      const auto bytes = read_file(file);
      if (!bytes) return bytes.error();
      listing += fs::relative(file, folders.root).generic_string() + " " + sha256(*bytes) + "\n";
    }
  }
  for (const auto& file : folders.overrides) {
    const auto bytes = read_file(file);
    if (!bytes) return bytes.error();
    listing += "override " + file.filename().string() + " " + sha256(*bytes) + "\n";
  }
  return sha256(listing);
}

namespace {

/// Errors: the kinds of `source` that no category of any backend has.
std::vector<Error> unknown_kinds(const Template& source, const std::vector<Backend>& backends) {
  std::set<std::string> known;
  for (const auto& backend : backends) {
    for (const auto& category : backend.knowledge.categories())
      known.insert(category.kinds.begin(), category.kinds.end());
  }
  std::vector<Error> errors;
  for (const auto& constraint : source.constraints) {
    if (constraint.type != ConstraintType::Kind) continue;
    for (std::size_t i = 1; i < constraint.arguments.size(); ++i) {
      const auto& kind = constraint.arguments[i];
      if (known.contains(kind)) continue;
      const auto near = nearest_name(kind, {known.begin(), known.end()});
      errors.push_back({Error::Kind::Schema, source.file, place_of(source.file, kind),
                        "no category is of the kind '" + kind + "'" +
                            (near.empty() ? "" : ", did you mean '" + near + "'") +
                            "; accepted are the kinds of data/sense/kinds.csv"});
    }
  }
  return errors;
}

}  // namespace

std::vector<Error> unknown_categories(const Template& source, const std::vector<Backend>& backends) {
  std::vector<std::string> named = categories_of(source.goal);
  for (const auto& formula : source.init) {
    const auto more = categories_of(formula);
    named.insert(named.end(), more.begin(), more.end());
  }
  std::sort(named.begin(), named.end());
  named.erase(std::unique(named.begin(), named.end()), named.end());

  std::vector<Error> errors = unknown_kinds(source, backends);
  for (const auto& name : named) {
    if (is_placeholder(source, name)) continue;
    const auto knows = [&](Simulator simulator) {
      return backends[static_cast<std::size_t>(simulator)].knowledge.find(name) != nullptr;
    };
    if (std::any_of(source.simulators.begin(), source.simulators.end(), knows)) continue;
    std::vector<std::string> accepted;
    for (const auto& parameter : source.parameters) accepted.push_back(parameter.name);
    for (const auto simulator : source.simulators) {
      const auto& knowledge = backends[static_cast<std::size_t>(simulator)].knowledge;
      for (const auto& category : knowledge.categories()) accepted.push_back(category.name);
    }
    const auto near = nearest_name(name, accepted);
    errors.push_back(
        {Error::Kind::Schema, source.file, place_of(source.file, name),
         "no knowledge base has the category \"" + name + "\"" +
             (near.empty() ? "" : ", did you mean \"" + near + "\"") +
             "; accepted are the template's parameters and the categories listed by `unietp knowledge show`"});
  }
  return errors;
}

}  // namespace unietp
