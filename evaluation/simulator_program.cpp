#include "evaluation/simulator_program.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <nlohmann/json.hpp>

#include "core/files.h"
#include "core/limits.h"
#include "core/unknown_name.h"
#include "evaluation/child_process.h"
#include "evaluation/evaluation_asset.h"
#include "evaluation/evaluation_manifest.h"
#include "record/record_fields.h"
#include "scene/json_parse.h"
#include "scene/node_json.h"
#include "scene/scene_json.h"
#include "scene/telling_order.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

/// A state in the words of answers.
Json facts_json(const Scene& scene) {
  Json states = Json::object(), edges = Json::array();
  for (const Node& node : scene.nodes) {
    Json& names = states[node.id] = Json::array();
    for (const State& state : node.states.all()) names.push_back(state_name(state));
  }
  for (const Edge& edge : scene.edges) edges.push_back({info(edge.relation).name, edge.from, edge.to});
  return {{"states", std::move(states)}, {"edges", std::move(edges)}, {"held", scene.agent.held}};
}

class SimulatorProgram : public ActingSimulator {
 public:
  explicit SimulatorProgram(SimulatorProgramOptions options) : options_(std::move(options)) {}

  Result<Done> begin(const EnvironmentTask& task) override {
    Json rooms = Json::array();
    for (const Room& room : in_telling_order(task.start).rooms) rooms.push_back(room.id);
    const auto line = call("begin", {{"task", task.text.id},
                                     {"folder", options_.folder.string()},
                                     {"rooms", std::move(rooms)},
                                     {"start", facts_json(task.start)}});
    if (!line) return line.error();
    if (auto read = read_result(*line, [](JsonReader&, JsonFields&) {}); !read) return failed(read.error());
    return Done{};
  }

  Result<SimulatorAnswer> act(const Action& action, const Scene& now, const Delta& ours) override {
    const auto line = call(
        "act", {{"action", info(action.type).name}, {"args", action.args}, {"ours", Json::parse(delta_to_json(ours))}});
    if (!line) return line.error();
    auto answer = read_simulator_answer(*line, calls_, now, ours);
    if (!answer) return failed(answer.error());
    return answer;
  }

  template <class Read>
  Result<Done> read_result(std::string_view line, const Read& read) const {
    return read_call(line, calls_, read);
  }

  /// Reads the result of a call with `read`.
  template <class Read>
  static Result<Done> read_call(std::string_view line, int id, const Read& read) {
    const auto json = parse_json("simulator's answer", line);
    if (!json) return json.error();
    JsonReader reader("simulator's answer");
    const JsonAt root{*json};
    JsonFields fields(reader, root);
    if (const auto f = fields.required("jsonrpc"); f && f->json != "2.0") reader.fail(*f, "expected \"2.0\"");
    if (const auto f = fields.required("id"); f && f->json != id)
      reader.fail(*f, "expected " + std::to_string(id) + ", the id of the call");
    if (const auto f = fields.optional("error")) {
      reader.fail(*f, "the simulator's program reports " + f->json.dump().substr(0, 300));
    } else if (const auto result = fields.required("result")) {
      JsonFields own(reader, *result);
      read(reader, own);
      own.finish();
    }
    fields.finish();
    if (reader.error()) return *reader.error();
    return Done{};
  }

 private:
  Result<std::string> call(const char* method, Json params) {
    if (!process_) {
      auto process = ChildProcess::start(options_.arguments);
      if (!process) return process.error();
      process_.emplace(std::move(*process));
    }
    const Json json{{"jsonrpc", "2.0"}, {"id", ++calls_}, {"method", method}, {"params", std::move(params)}};
    auto line = process_->exchange(json.dump(-1, ' ', false, Json::error_handler_t::replace), options_.reply_s,
                                   limits::kMessageBytes, options_.stop);
    if (!line) return failed(line.error());
    return line;
  }

  /// Whatever the program is doing, the next episode begins with a new one.
  Error failed(Error error) {
    process_.reset();
    return error;
  }

  SimulatorProgramOptions options_;
  std::optional<ChildProcess> process_;
  int calls_ = 0;
};

/// Adds the nodes that are new or whose states changed, as they are now.
void read_states(JsonReader& reader, const JsonAt& at, const Scene& now, const Delta& ours, Delta& changes) {
  if (!at.json.is_object()) return reader.fail(at, "expected an object of lists of states");
  for (const auto& entry : at.json.items()) {
    const std::string& id = entry.key();
    const JsonAt item{entry.value(), &at, id};
    const Node* const node = find_node(now, id);
    const auto made = std::find_if(ours.nodes.begin(), ours.nodes.end(), [&](const Node& one) { return one.id == id; });
    if (node == nullptr && made == ours.nodes.end()) return reader.fail(item, "expected the id of an object");
    Node changed = node != nullptr ? *node : *made;
    changed.states.clear(Predicate::Covered);  // the other states exclude each other, and are replaced
    const std::size_t count = reader.items(item);
    for (std::size_t i = 0; i < count && !reader.error(); ++i) {
      if (const auto state = state_from_json(reader, reader.item(item, i))) changed.states.set(*state);
    }
    if (node == nullptr || changed != *node) changes.nodes.push_back(std::move(changed));
  }
}

void read_edges(JsonReader& reader, const JsonAt& at, std::vector<Edge>& edges) {
  const std::size_t count = reader.items(at);
  for (std::size_t i = 0; i < count && !reader.error(); ++i) {
    const JsonAt item = reader.item(at, i);
    const auto words = reader.texts(item);
    const auto relation = words.size() == 3 ? predicate_named(words.front()) : std::nullopt;
    if (!relation || !is_edge_relation(*relation)) return reader.fail(item, "expected a relation and two ids");
    edges.push_back({*relation, words[1], words[2]});
  }
  std::sort(edges.begin(), edges.end());
}

/// What changed of a state.
void read_change(JsonReader& reader, JsonFields& fields, const Scene& now, const Delta& ours, Delta& changes) {
  if (const auto f = fields.required("states")) read_states(reader, *f, now, ours, changes);
  if (const auto f = fields.required("edges_added")) read_edges(reader, *f, changes.edges_added);
  if (const auto f = fields.required("edges_removed")) read_edges(reader, *f, changes.edges_removed);
  if (const auto f = fields.optional("held")) {
    changes.agent = now.agent;
    changes.agent->held = reader.texts(*f);
  }
}

}  // namespace

Result<SimulatorAnswer> read_simulator_answer(std::string_view line, int id, const Scene& now, const Delta& ours) {
  SimulatorAnswer answer;
  const auto read = SimulatorProgram::read_call(line, id, [&](JsonReader& reader, JsonFields& fields) {
    if (const auto f = fields.required("success")) answer.success = reader.boolean(*f);
    if (const auto f = fields.required("message")) answer.message = text_or_empty(reader, *f);
    read_change(reader, fields, now, ours, answer.changes);
    const auto moments = fields.optional("moments");
    Scene then = moments ? now : Scene();
    const std::size_t count = moments ? reader.items(*moments) : 0;
    for (std::size_t i = 0; i < count && !reader.error(); ++i) {
      const JsonAt item = reader.item(*moments, i);
      JsonFields own(reader, item);
      read_change(reader, own, then, ours, answer.moments.emplace_back());
      own.finish();
      then = apply(std::move(then), answer.moments.back());
    }
    if (count == 1 && !reader.error()) reader.fail(*moments, "expected two or more moments");
    if (count > 1 && !difference(then, apply(now, answer.changes)).empty())
      reader.fail(*moments, "expected moments that lead to what changed as a whole");
  });
  if (!read) return read.error();
  return answer;
}

SharedSimulator simulator_program(SimulatorProgramOptions options) {
  return std::make_shared<SimulatorProgram>(std::move(options));
}

const std::vector<std::string>& simulator_backends() {
  static const std::vector<std::string> kNames{"virtualhome", "ai2thor", "behavior", "habitat"};
  return kNames;
}

Result<std::vector<std::string>> simulator_command(const std::string& backend, const std::filesystem::path& folder) {
  const auto& names = simulator_backends();
  if (std::find(names.begin(), names.end(), backend) == names.end()) {
    auto accepted = names;
    accepted.insert(accepted.begin(), kOwnBackend);
    return unknown_name_error("--backend", backend, accepted);
  }
  const std::string program = "act_" + backend + ".py";
  for (const std::string& file : {program, std::string("acting.py"), "run_" + backend + ".py"}) {
    const std::string_view text = evaluation_asset(file);
    if (text.empty()) continue;  // not every one has a runner of its own
    if (auto written = write_file(folder, file, text); !written) return written.error();
  }
  return std::vector<std::string>{"python3", (folder / program).string()};
}

}  // namespace unietp
