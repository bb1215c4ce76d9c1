#include "audit/task_questions.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>
#include <set>
#include <unordered_map>
#include <utility>

#include "audit/word_key.h"
#include "core/text.h"
#include "logic/evaluate.h"
#include "scene/trace.h"
#include "scores/goal_objects.h"
#include "simulation/mode_rules.h"

namespace unietp {
namespace {

using Places = std::unordered_map<std::string, std::size_t>;  // never iterated

/// Letters and digits of a text in lower case, as words: "Put the TVRemote" gives put, the, tvremote.
std::vector<std::string> words_of(std::string_view text) {
  std::vector<std::string> words(1);
  for (const char c : text) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) {
      words.back() += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    } else if (!words.back().empty()) {
      words.emplace_back();
    }
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

/// The words of a category: "WineBottle" and "wine_bottle.n.01" give wine, bottle.
std::vector<std::string> words_of_category(std::string_view category) {
  std::string text(category.substr(0, category.find(".n.")));
  for (std::size_t i = text.size(); i-- > 1;) {
    if (std::isupper(static_cast<unsigned char>(text[i])) != 0 &&
        std::islower(static_cast<unsigned char>(text[i - 1])) != 0)
      text.insert(i, " ");
  }
  return words_of(text);
}

/// Whether each of the words, or its plural, is in the text.
bool names(const std::vector<std::string>& text, const std::vector<std::string>& words) {
  return std::all_of(words.begin(), words.end(), [&](const std::string& word) {
    return std::any_of(text.begin(), text.end(), [&](const std::string& one) {
      return one == word ||
             (one.starts_with(word) && (one.substr(word.size()) == "s" || one.substr(word.size()) == "es"));
    });
  });
}

float number_of(std::string_view id) {
  std::size_t start = id.size();
  while (start > 0 && std::isdigit(static_cast<unsigned char>(id[start - 1])) != 0 && id.size() - start < 6) --start;
  float number = 0;
  for (const char c : id.substr(start)) number = 10 * number + static_cast<float>(c - '0');
  return number;
}

bool is_place(Predicate one) {
  return one == Predicate::On || one == Predicate::Inside || one == Predicate::NextTo || one == Predicate::Under ||
         one == Predicate::Nearest || one == Predicate::OnFloor || one == Predicate::InRoom;
}

/// What the instruction speaks of: the states of the whole goal ("the dirty one", "switch it off"), and the places of
/// its phrases, the `:where` of its domains.
void asked_in(const Formula& formula, bool inside_where, std::set<Predicate>& asked) {
  if (formula.op == Formula::Op::Atom && (inside_where || !is_place(formula.predicate)))
    asked.insert(formula.predicate);
  for (const Formula& where : formula.domain.where) asked_in(where, true, asked);
  for (const Formula& child : formula.children) asked_in(child, inside_where, asked);
}

bool asks_for_place(const std::set<Predicate>& asked) { return std::any_of(asked.begin(), asked.end(), is_place); }

std::string_view default_of(std::string_view group) {
  for (const PredicateInfo& one : all_predicates()) {
    if (one.group == group && one.by_default) return one.name;
  }
  return {};
}

/// The affordance whose states exclude each other; what is filled with anything is not empty.
std::string_view group_of(Predicate state) { return info(state == Predicate::Filled ? Predicate::Empty : state).group; }

/// States that are asked for are taken to be as they are at first: left out, they would set the thing apart, too.
std::uint64_t key_of_states(const StateSet& states, const std::set<Predicate>& asked) {
  std::set<std::string> as_known;  // sorted: what is filled lists its states in another order than what is empty
  for (const State& state : states.all()) {
    const auto group = group_of(state.predicate);
    const bool is_asked = std::any_of(asked.begin(), asked.end(), [&](Predicate one) {
      return one == state.predicate || (!group.empty() && group_of(one) == group);
    });
    if (!is_asked) {
      as_known.insert(std::string(info(state.predicate).name) + " " + state.symbol);
    } else if (!group.empty()) {
      as_known.insert(std::string(default_of(group)) + " ");
    }
  }
  std::string text;
  for (const std::string& state : as_known) text += state + ",";
  return word_key(text);
}

/// The start as options, and where each of its things and rooms is among them.
struct Options {
  std::vector<GuessOption> things, rooms;  // in the order of the scene
  Places place_of_thing, place_of_room;
};

/// Marks what is where the goal speaks of: "leave one pillow on the bench" says that pillows are on it.
void mark_asked_places(Options& all, const Scene& start, const Formula& goal) {
  std::set<Predicate> asked;
  asked_in(goal, true, asked);
  for (GuessOption& thing : all.things) thing.is_where_asked = thing.support == 0 && asked.contains(Predicate::OnFloor);
  const auto categories = categories_of(goal);
  for (const Edge& edge : start.edges) {
    const auto thing = all.place_of_thing.find(edge.from), below = all.place_of_thing.find(edge.to);
    if (edge.relation != Predicate::On && edge.relation != Predicate::Inside) continue;
    if (thing == all.place_of_thing.end() || below == all.place_of_thing.end()) continue;
    if (std::find(categories.begin(), categories.end(), start.nodes[below->second].category) != categories.end())
      all.things[thing->second].is_where_asked = true;
  }
}

Options options_of(const Scene& start, const std::set<Predicate>& asked, const std::vector<std::string>& words) {
  Options all;
  const auto sort = static_cast<std::uint64_t>(start.simulator);
  for (const Room& room : start.rooms) {
    GuessOption option;
    option.kind = option.room_type = word_key(room.type, sort);
    option.room = static_cast<int>(all.rooms.size());
    option.number = number_of(room.id);
    Vec2 middle = Vec2::Zero();
    for (const Vec2& corner : room.polygon) middle += corner / static_cast<double>(room.polygon.size());
    option.distance =
        room_at(start, start.agent.position) == &room ? 0 : static_cast<float>((middle - start.agent.position).norm());
    all.place_of_room.emplace(room.id, all.rooms.size());
    all.rooms.push_back(option);
  }
  std::map<std::string, bool, std::less<>> named;
  for (const Node& node : start.nodes) {
    GuessOption option;
    option.kind = word_key(node.category, sort);
    option.states = key_of_states(node.states, asked);
    option.has_asset = !node.asset.empty();
    const auto [known, is_new] = named.emplace(node.category, false);
    if (is_new) known->second = names(words, words_of_category(node.category));
    option.is_named = known->second;
    option.number = number_of(node.id);
    option.distance = static_cast<float>((node.pose.position.head<2>() - start.agent.position).norm());
    all.place_of_thing.emplace(node.id, all.things.size());
    all.things.push_back(option);
  }
  for (const Edge& edge : start.edges) {
    const auto thing = all.place_of_thing.find(edge.from);
    if (thing == all.place_of_thing.end()) continue;
    GuessOption& option = all.things[thing->second];
    if (const auto room = all.place_of_room.find(edge.to);
        room != all.place_of_room.end() && edge.relation == Predicate::InRoom) {
      option.room = static_cast<int>(room->second);
      option.room_type = all.rooms[room->second].kind;
    }
    const auto below = all.place_of_thing.find(edge.to);
    if (below != all.place_of_thing.end() && (edge.relation == Predicate::On || edge.relation == Predicate::Inside))
      option.support = all.things[below->second].kind + (edge.relation == Predicate::Inside ? 1 : 0);
  }
  return all;
}

/// Gives the options of a list the places that they have in it, and counts those of one kind.
void set_places(std::vector<GuessOption>& options) {
  std::map<std::uint64_t, std::vector<GuessOption*>> kinds;
  for (std::size_t i = 0; i < options.size(); ++i) {
    options[i].place = options.size() < 2 ? 0 : static_cast<float>(i) / static_cast<float>(options.size() - 1);
    kinds[options[i].kind].push_back(&options[i]);
  }
  for (auto& [kind, alike] : kinds) {
    for (GuessOption* option : alike) {
      const auto below = std::count_if(alike.begin(), alike.end(),
                                       [&](const GuessOption* other) { return other->number < option->number; });
      option->of_kind = static_cast<float>(alike.size());
      option->number_rank = alike.size() < 2 ? 0.5F : static_cast<float>(below) / static_cast<float>(alike.size() - 1);
      option->alike = static_cast<float>(std::count_if(
          alike.begin(), alike.end(), [&](const GuessOption* other) { return other->states == option->states; }));
    }
  }
}

class Asker {
 public:
  Asker(const FinishedTask& task, AuditedTask& made, const std::set<Predicate>& asked)
      : task_(task), made_(made), asked_(asked), options_(options_of(task.start, asked, made.words)) {
    const Trace trace = to_logic(task.start, {}, reads_comparisons(task.record.goal_tree));
    needs_ = goal_objects(task.record.goal_tree, trace);
    for (const GoalObjects& objects : needs_) needed_.insert(objects.referents.begin(), objects.referents.end());
    mark_asked_places(options_, task.start, task.record.goal_tree);
  }

  void ask_all() {
    const auto m1 = global_information(task_.start, rules_of(Mode::M1));
    set_list_places(m1.movables);
    set_list_places(m1.furniture);
    made_.things = options_.things;
    for (const Node& node : task_.start.nodes) made_.needed.push_back(needed_.contains(node.id));
    ask(GuessChoice::SmallThing, Mode::M1, m1.movables, needed_);
    ask(GuessChoice::Furniture, Mode::M2, m1.furniture, needed_);
    for (const GoalObjects& objects : needs_) ask_which(objects, m1);
    ask_rooms(global_information(task_.start, rules_of(Mode::M3)).rooms);
    for (const auto& [mode, shown] : task_.shown) ask_of_demonstration(mode, shown);
  }

 private:
  const GuessOption* option_of(const std::string& id) const {
    if (const auto thing = options_.place_of_thing.find(id); thing != options_.place_of_thing.end())
      return &options_.things[thing->second];
    const auto room = options_.place_of_room.find(id);
    return room == options_.place_of_room.end() ? nullptr : &options_.rooms[room->second];
  }

  void set_list_places(const std::vector<std::string>& ids) {
    std::vector<GuessOption> listed;
    for (const auto& id : ids) listed.push_back(*option_of(id));
    set_places(listed);
    for (std::size_t i = 0; i < ids.size(); ++i) options_.things[options_.place_of_thing.at(ids[i])] = listed[i];
  }

  void keep(GuessQuestion question) {
    const auto right = std::count(question.right.begin(), question.right.end(), true);
    if (right > 0 && right < static_cast<std::ptrdiff_t>(question.right.size()))
      made_.questions.push_back(std::move(question));
  }

  void ask(GuessChoice choice, Mode mode, const std::vector<std::string>& ids,
           const std::set<std::string, std::less<>>& right) {
    GuessQuestion question{choice, mode, {}, {}};
    for (const auto& id : ids) {
      question.options.push_back(*option_of(id));
      question.right.push_back(right.contains(id));
    }
    keep(std::move(question));
  }

  /// Which of the things of some kinds a phrase means; in the order of the list that has them.
  void ask_which(const GoalObjects& objects, const GlobalInformation& lists) {
    const auto chosen = [&](const std::vector<std::string>& list) {
      std::vector<std::string> ids;
      for (const auto& id : list) {
        if (objects.referents.contains(id) || objects.alike.contains(id)) ids.push_back(id);
      }
      return ids;
    };
    auto furniture = chosen(lists.furniture), movables = chosen(lists.movables);
    const Mode mode = movables.empty() ? Mode::M2 : Mode::M1;
    furniture.insert(furniture.end(), movables.begin(), movables.end());
    GuessQuestion question{GuessChoice::OfKind, mode, {}, {}};
    for (const auto& id : furniture) {
      question.options.push_back(*option_of(id));
      question.right.push_back(objects.referents.contains(id));
    }
    std::vector<std::uint64_t> kinds;
    for (GuessOption& option : question.options) kinds.push_back(std::exchange(option.kind, 0));
    set_places(question.options);  // as of one kind
    for (std::size_t i = 0; i < kinds.size(); ++i) question.options[i].kind = kinds[i];
    if (asks_for_place(asked_)) {
      for (GuessOption& option : question.options) {
        option.support = option.room_type = 0;
        option.is_where_asked = false;
      }
    }
    keep(std::move(question));
  }

  void ask_rooms(const std::vector<std::string>& ids) {
    std::set<std::string, std::less<>> right;
    for (const Edge& edge : task_.start.edges) {
      if (edge.relation != Predicate::InRoom || !needed_.contains(edge.from)) continue;
      if (const Node* node = find_node(task_.start, edge.from); node != nullptr && node->movable) right.insert(edge.to);
    }
    std::vector<GuessOption> listed;
    for (const auto& id : ids) listed.push_back(*option_of(id));
    set_places(listed);
    for (std::size_t i = 0; i < ids.size(); ++i) options_.rooms[options_.place_of_room.at(ids[i])] = listed[i];
    ask(GuessChoice::Room, Mode::M3, ids, right);
  }

  void ask_of_demonstration(Mode mode, const DemonstrationRecord& shown) {
    if (shown.steps.empty()) return;
    const StepRecord& first = shown.steps.front();
    GuessQuestion view{GuessChoice::InView, mode, {}, {}};
    for (const VisibleObject& seen : first.visible) {
      const GuessOption* known = option_of(seen.id);
      if (known == nullptr) continue;
      GuessOption option = *known;
      option.area = static_cast<float>((seen.box[2] - seen.box[0] + 1) * (seen.box[3] - seen.box[1] + 1));
      option.low_edge = static_cast<float>(seen.box[3]);
      view.options.push_back(option);
      view.right.push_back(needed_.contains(seen.id));
    }
    set_places(view.options);
    if (mode != Mode::M1) keep(std::move(view));  // M1 shows what M2 does
    if (first.command.args.empty() || first.command.args.front().id.empty()) return;
    const auto lists = global_information(task_.start, rules_of(mode));
    std::vector<std::string> ids = lists.rooms;
    ids.insert(ids.end(), lists.furniture.begin(), lists.furniture.end());
    ids.insert(ids.end(), lists.movables.begin(), lists.movables.end());
    ask(GuessChoice::FirstObject, mode, ids, {first.command.args.front().id});
  }

  const FinishedTask& task_;
  AuditedTask& made_;
  const std::set<Predicate>& asked_;
  Options options_;
  std::vector<GoalObjects> needs_;
  std::set<std::string, std::less<>> needed_;
};

}  // namespace

AuditedTask audited_task(const FinishedTask& task) {
  AuditedTask made;
  made.id = task.record.id;
  made.split = task.record.split;
  made.template_name = task.record.template_name;
  made.home = task.record.layout;
  made.simulator = task.start.simulator;
  made.words = words_of(task.record.instruction);
  std::set<Predicate> asked;
  asked_in(task.record.goal_tree, false, asked);
  Asker(task, made, asked).ask_all();
  return made;
}

}  // namespace unietp
