#include "serve/play_line.h"

#include <algorithm>
#include <charconv>
#include <optional>

#include <nlohmann/json.hpp>

#include "core/in_quotes.h"
#include "core/text.h"
#include "scene/action.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

Error no_line(std::string message) { return {Error::Kind::Usage, "", {}, std::move(message)}; }

std::vector<std::string> words_of(std::string_view line) {
  std::vector<std::string> words;
  for (auto& word : split(replace_all(std::string(line), "\t", " "), ' ')) {
    if (!word.empty()) words.push_back(std::move(word));
  }
  return words;
}

std::optional<int> number_of(std::string_view text) {
  int value = 0;
  const char* const end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, value);
  return read.ec == std::errc{} && read.ptr == end ? std::optional(value) : std::nullopt;
}

/// The numbers of "10,20" or "10,20,30,40"; nullopt for anything else.
std::optional<std::vector<int>> numbers_of(std::string_view text) {
  std::vector<int> numbers;
  for (const auto& part : split(text, ',')) {
    const auto number = number_of(part);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers.size() == 2 || numbers.size() == 4 ? std::optional(numbers) : std::nullopt;
}

/// Which action the most words at the beginning name, and how many words those are.
struct FoundAction {
  std::string name;
  std::size_t words = 0;
};

Result<FoundAction> find_action(const std::vector<std::string>& words, const std::vector<std::string>& actions) {
  std::vector<std::string> beginning;
  for (std::size_t count = words.size(); count > 0; --count) {
    const std::string said = lower(join({words.begin(), words.begin() + static_cast<std::ptrdiff_t>(count)}, "_"));
    beginning.clear();
    for (const auto& action : actions) {
      if (action == said) return FoundAction{action, count};
      if (action.starts_with(said)) beginning.push_back(action);
    }
    if (beginning.size() == 1) return FoundAction{beginning.front(), count};
    if (!beginning.empty()) return no_line("more than one action begins so: " + join(beginning, ", "));
  }
  const auto near = nearest_name(lower(words.front()), actions);
  return no_line("no action " + in_quotes(words.front()) + "; " + (near.empty() ? "" : "did you mean " + near + "? ") +
                 "`actions` lists them");
}

/// Errors: Usage for an action that lacks what it is done to, or is given more than it takes. It is not tried, since a
/// slip of the hand should not cost a step.
Result<Done> check_count(const std::string& action, std::size_t given) {
  const auto type = action_named(action);
  const std::size_t wanted = !type || info(*type).argument == ActionArgument::None ? 0 : 1;
  if (!type || given == wanted) return Done{};
  if (given > wanted) return no_line(action + (wanted == 0 ? " is done to nothing" : " is done to one thing"));
  return no_line(action + " what? Add its number in the last list, its id, or in M3 a point of the picture");
}

/// Errors: Usage for a number that nothing has.
Result<Json> argument_of(const std::string& word, const std::vector<ListedThing>& listed) {
  if (const auto numbers = numbers_of(word)) return Json{{numbers->size() == 2 ? "point" : "bbox", *numbers}};
  const auto number = number_of(word);
  if (!number) return Json(word);
  if (*number < 1 || static_cast<std::size_t>(*number) > listed.size())
    return no_line("nothing has the number " + word + "; `look` and `home` number what they list");
  return Json(listed[static_cast<std::size_t>(*number) - 1].id);
}

}  // namespace

Result<std::string> typed_action(std::string_view line, const std::vector<std::string>& actions,
                                 const std::vector<ListedThing>& listed) {
  std::string plain(line);
  for (const char* sign : {"(", ")"}) plain = replace_all(plain, sign, " ");
  const auto words = words_of(replace_all(plain, ", ", ","));
  if (words.empty()) return no_line("expected an action");
  const auto found = find_action(words, actions);
  if (!found) return found.error();
  if (const auto fine = check_count(found->name, words.size() - found->words); !fine) return fine.error();
  Json arguments = Json::array();
  for (std::size_t i = found->words; i < words.size(); ++i) {
    auto argument = argument_of(words[i], listed);
    if (!argument) return argument.error();
    arguments.push_back(std::move(*argument));
  }
  return Json{{"action", found->name}, {"args", std::move(arguments)}}.dump(-1, ' ', false,
                                                                            Json::error_handler_t::replace);
}

}  // namespace unietp
