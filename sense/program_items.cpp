#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <tuple>

#include <nlohmann/json.hpp>

#include "core/files.h"
#include "core/text.h"
#include "sense/action_roles.h"
#include "sense/items.h"

namespace unietp {
namespace {

constexpr std::string_view kPrograms = "metadata:activity_programs.jsonl.gz", kList = "programs";

/// A step's first words and the role that they mean.
constexpr std::array<std::pair<std::string_view, std::string_view>, 14> kDeeds{{{"Wash ", "wash"},
                                                                                {"Rinse ", "wash"},
                                                                                {"Scrub ", "wash"},
                                                                                {"Wipe ", "wash"},
                                                                                {"Open ", "open"},
                                                                                {"Close ", "close"},
                                                                                {"Switch on ", "switch_on"},
                                                                                {"Switch off ", "switch_off"},
                                                                                {"Read ", "read"},
                                                                                {"Cut ", "slice"},
                                                                                {"Plug in ", "plug_in"},
                                                                                {"Plug out ", "unplug"},
                                                                                {"Sit on ", "sit"},
                                                                                {"Lie on ", "lie"}}};

struct ProgramAction {
  std::string thing;  // kind
  Role role;
  std::string word;  // of the thing
};

/// "Put mug on table" -> mug, table; nullopt without such a word between them.
std::optional<std::pair<std::string, std::string>> halves(const std::string& step, std::string_view verb,
                                                          const std::vector<std::string_view>& between) {
  if (!step.starts_with(verb)) return std::nullopt;
  const auto rest = step.substr(verb.size());
  std::size_t first = std::string::npos, length = 0;
  for (const auto word : between) {
    const auto at = rest.find(word);
    if (at < first) {
      first = at;
      length = word.size();
    }
  }
  if (first == std::string::npos) return std::nullopt;
  return std::pair(rest.substr(0, first), rest.substr(first + length));
}

std::optional<ProgramAction> placed(const std::string& step, const Vocabulary& vocabulary) {
  const auto parts = halves(step, "Put ", {" on ", " in "});
  if (!parts) return std::nullopt;
  const auto thing = vocabulary.words.of_word(parts->first, kList);
  const auto place = vocabulary.words.of_word(parts->second, kList);
  if (!thing || !place) return std::nullopt;
  return ProgramAction{*thing, usual_place(vocabulary.kinds, *place), parts->first};
}

std::optional<ProgramAction> poured(const std::string& step, const Vocabulary& vocabulary) {
  const auto parts = halves(step, "Pour ", {" into ", " on ", " in "});
  if (!parts) return std::nullopt;
  const auto target = vocabulary.words.of_word(parts->second, kList);
  if (!target) return std::nullopt;
  if (std::find(kLiquids.begin(), kLiquids.end(), parts->first) != kLiquids.end())
    return ProgramAction{*target, "fill:" + parts->first, parts->second};
  const auto substance = vocabulary.words.of_word(parts->first, kList);
  if (!substance) return std::nullopt;
  return ProgramAction{*target, "cover:" + *substance, parts->second};
}

std::optional<ProgramAction> action_of(const std::string& step, const Vocabulary& vocabulary) {
  if (auto action = placed(step, vocabulary)) return action;
  if (auto action = poured(step, vocabulary)) return action;
  for (const auto& [words, role] : kDeeds) {
    if (!step.starts_with(words)) continue;
    const auto word = step.substr(words.size());
    if (const auto thing = vocabulary.words.of_word(word, kList)) return ProgramAction{*thing, std::string(role), word};
  }
  return std::nullopt;
}

using Times = std::map<std::tuple<std::string, std::string, Role, std::string>, int>;  // title, thing, role, step

/// Counts each action of a program once, and each pair of actions that follow one another with one thing.
void count_program(const std::string& title, const nlohmann::json& steps, const Vocabulary& vocabulary, Times& times) {
  std::map<std::tuple<std::string, std::string, Role, std::string>, bool> seen;
  std::map<std::string, Role> last;  // by word of the thing
  for (const auto& step : steps) {
    if (!step.is_string()) continue;
    const auto text = step.get<std::string>();
    const auto action = action_of(text, vocabulary);
    if (!action) continue;
    seen[{title, action->thing, action->role, text}] = true;
    Role& before = last[action->word];
    if (!before.empty() && before != action->role && family_of(before) != "place")
      seen[{title, action->thing, before + ">" + action->role, text}] = true;
    before = action->role;
  }
  for (const auto& [key, once] : seen) ++times[key];
}

}  // namespace

Result<std::vector<Item>> program_items(const std::filesystem::path& file, const Vocabulary& vocabulary) {
  const auto text = read_maybe_gzip(file);
  if (!text) return text.error();
  Times times;
  int line = 0;
  for (const auto& program : split(*text, '\n')) {
    ++line;
    if (program.empty()) continue;
    const auto json = nlohmann::json::parse(program, nullptr, false);
    if (!json.is_object() || !json.contains("title") || !json["title"].is_string() || !json.contains("steps"))
      return Error{Error::Kind::Parse, file.string(), {line, 1}, "expected an object with title and steps"};
    count_program(json["title"].get<std::string>(), json["steps"], vocabulary, times);
  }
  std::vector<Item> items;
  for (const auto& [key, count] : times) {
    const auto& [title, thing, role, step] = key;
    const double weight = std::min(4.0, 1 + (count - 1) / 8.0);
    items.push_back({{thing, role, weight, title + ": " + step, std::string(kPrograms)}, title});
  }
  return items;
}

}  // namespace unietp
