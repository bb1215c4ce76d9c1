#include "sample_records.h"

namespace unietp {

EpisodeRecord sample_episode() {
  EpisodeStep first;
  first.prompt = std::string(64, 'a');
  first.reply = "I go. {\"action\": \"go_to\", \"args\": [\"mug_1\"]}\n\xC3\xA9";
  first.thinking = "The mug is in the kitchen.";
  first.finish = "stop";
  first.actions = {{{"go_to", {{"mug_1", std::nullopt}}}, true, "none", "", true},
                   {{"pick_up", {{"", PixelBox{1, 2, 30, 40}}}}, false, "not_visible", "You do not see it.", true}};
  first.progress = 0.1;
  first.prompt_tokens = 1200;
  first.completion_tokens = 30;
  first.cost = 0.00021;
  EpisodeStep second;
  second.reply = "no idea";
  second.finish = "length";
  second.unreadable = "expected one JSON object";
  second.actions = {{{}, false, "invalid_action", "Say it as JSON.", false}};
  EpisodeStep third;
  third.reply = "stop";
  third.actions = {{{"stop", {}}, true, "none", "", true}};
  Delta moved;
  moved.edges_added = {{Predicate::On, "mug_1", "table_1"}};
  moved.edges_removed = {{Predicate::InRoom, "mug_1", "kitchen_1"}};
  first.actions.front().simulator = SimulatorAnswer{true, "", moved};
  first.actions.push_back({{"open", {{"fridge_1", std::nullopt}}},
                           false,
                           "not_offered",
                           "The simulator refuses: locked",
                           true,
                           SimulatorAnswer{false, "locked", {}}});
  third.progress = 1;
  EpisodeRecord episode;
  episode.key = {"ai2thor-00001", Mode::M2, 3};
  episode.simulator = "ai2thor";
  episode.split = "atomic";
  episode.template_name = "open-one";
  episode.layout = "ai2thor-benchmark-01";
  episode.steps = {first, second, third};
  episode.success = true;
  episode.progress = 1;
  episode.counted = 3;
  episode.failures = 1;
  episode.models = {"model-2026-01", "model-2026-02"};
  return episode;
}

EpisodeRecord errored_episode() {
  EpisodeRecord episode = sample_episode();
  episode.steps.pop_back();
  episode.end = EpisodeOutcome::Errored;
  episode.success = false;
  episode.progress = 0;
  episode.error = EpisodeError{EpisodeErrorKind::Timeout, "no answer within 120 s"};
  return episode;
}

TimingRecord sample_timing() { return {{"ai2thor-00001", Mode::M2, 3}, {0.5, 0, 12.25}, {1, 0, 3}, 0.004, 5}; }

EvaluationManifest sample_manifest() {
  EvaluationManifest manifest;
  EvaluationSetup& setup = manifest.setup;
  setup.program_version = "0.1.0";
  setup.program_build = "GNU 12.2.0, Release";
  setup.program_digest = std::string(64, 'e');
  setup.knowledge_digest = std::string(64, 'b');
  setup.dataset = {"benchmark", "unietp-1.0", std::string(64, 'c'), 536};
  setup.agent = {AgentKind::Model, "some-model", {{"agent.py", std::string(64, 'f')}}};
  setup.selection.modes = {Mode::M1, Mode::M2};
  setup.selection.splits = {"atomic"};
  setup.selection.simulators = {"ai2thor", "habitat"};
  setup.selection.limit = 20;
  setup.selection.repeats = 4;
  setup.selection.seed = 7;
  setup.settings = {{Mode::M1, settings_for(Mode::M1)}, {Mode::M2, settings_for(Mode::M2, Conventions::Release)}};
  setup.talk = TalkSettings{"release", std::string(64, 'd'), 5, 0, true, true, true, true};
  setup.sampling = SamplingSettings{0.2, 0.95, 2048, 1, R"({"min_p":0.1,"stop":["x"]})"};
  setup.price_in = 0.15;
  setup.price_out = 0.6;
  manifest.totals = {160, 158, 2, {"model-2026-01"}, 1'234'567, 8900, 0.19};
  manifest.report_pictures = 12;
  manifest.files = {{kEpisodesFile, std::string(64, 'e')}, {kTimingFile, std::string(64, 'f')}};
  return manifest;
}

}  // namespace unietp
