#include "corruptions.h"

#include <algorithm>
#include <optional>

namespace unietp {

using Json = nlohmann::ordered_json;

namespace {

/// The goal's first referring constraint: where `:where f` has its f, from and to.
struct Where {
  std::size_t from = 0, to = 0;
};
std::optional<Where> where_in(const std::string& goal) {
  const auto mark = goal.find(":where ");
  if (mark == std::string::npos) return std::nullopt;
  const auto from = goal.find('(', mark);
  int depth = 0;
  for (auto at = from; at < goal.size(); ++at) {
    if (goal[at] == '(') ++depth;
    if (goal[at] == ')' && --depth == 0) return Where{from, at + 1};
  }
  return std::nullopt;
}

/// The goal with its first `:where f` as `with(f)` says.
template <class With>
bool change_where(DamagedTask& damaged, With with) {
  if (damaged.task["split"] != "instance_grounding") return false;
  const auto goal = damaged.goal();
  const auto where = where_in(goal);
  if (!where) return false;
  const auto f = goal.substr(where->from, where->to - where->from);
  damaged.set_goal(goal.substr(0, where->from) + with(f) + goal.substr(where->to));
  return true;
}

/// `(and … extra)` at the end, with an object as ?z.
bool extend_goal(DamagedTask& damaged, const std::string& extra) {
  damaged.set_goal("(and " + damaged.goal() + " " + extra + ")");
  return true;
}

Json& steps_of(DamagedTask& damaged) { return damaged.demonstration["steps"]; }

/// The goal becomes that the first thing picked up is in the hand at some time: whatever comes then is in vain.
bool ask_for_less(DamagedTask& damaged, const char* then) {
  for (auto step = steps_of(damaged).begin(); step != steps_of(damaged).end(); ++step) {
    if ((*step)["action"] != "pick_up") continue;
    const bool there =
        std::any_of(step, steps_of(damaged).end(), [&](const Json& one) { return one["action"] == then; });
    if (!there) return false;
    damaged.set_goal("(exists (?z - " + damaged.category_of((*step)["args"][0]) + ") (sometime (held ?z)))");
    return true;
  }
  return false;
}

bool has_size(const std::string& text, std::size_t words) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), ' ')) + 1 >= words;
}

/// Whether there is another thing of the same category that is in nothing with a door.
bool another_lies_open(const DamagedTask& s, const std::string& id) {
  const auto opens = [&s](const Json& thing) {
    const auto& nodes = s.scene["nodes"];
    return std::any_of(nodes.begin(), nodes.end(),
                       [&](const Json& node) { return node["id"] == thing && node["openable"].get<bool>(); });
  };
  const auto shut_in = [&](const Json& thing) {
    const auto& edges = s.scene["edges"];
    return std::any_of(edges.begin(), edges.end(), [&](const Json& edge) {
      return edge["relation"] == "inside" && edge["from"] == thing && opens(edge["to"]);
    });
  };
  const auto& nodes = s.scene["nodes"];
  return std::any_of(nodes.begin(), nodes.end(), [&](const Json& node) {
    return node["category"] == s.category_of(id) && node["id"] != id && !shut_in(node["id"]);
  });
}

}  // namespace

const std::vector<Corruption> kCorruptions{
    {"AnOutcomeTurnedRound", "outcome",
     [](DamagedTask& s) {
       steps_of(s)[0]["success"] = false;
       return true;
     }},
    {"AnotherFeedback", "outcome",
     [](DamagedTask& s) {
       steps_of(s)[0]["feedback"] = "You are there.";
       return true;
     }},
    {"FormsLeftOut", "forms", [](DamagedTask& s) { return !std::exchange(s.task["forms"], Json::array()).empty(); }},
    {"AMomentWithinACompositeActionLeftOut", "changes",
     [](DamagedTask& s) {
       for (Json& step : steps_of(s)) {
         if (!step.contains("moments") || step["moments"].size() < 3) continue;
         step["moments"].erase(step["moments"].begin() + 1);
         return true;
       }
       return false;
     }},
    {"ADoorThatStaysShutWithinACompositeAction", "changes",
     [](DamagedTask& s) {
       for (Json& step : steps_of(s)) {
         if (!step.contains("moments")) continue;
         for (Json& node : step["moments"][0]["nodes"]) {
           for (Json& state : node["states"]) {
             if (state != "open") continue;
             state = "closed";
             return true;
           }
         }
       }
       return false;
     }},
    {"AnActionWithALetterChanged", "unreadable",
     [](DamagedTask& s) {
       steps_of(s)[0]["action"] = "go_ta";
       return true;
     }},
    {"AnUnknownField", "unreadable",
     [](DamagedTask& s) {
       s.task["surprise"] = 1;
       return true;
     }},
    {"ABrokenLine", "unreadable",
     [](DamagedTask& s) {
       s.task_line = "[" + s.task.dump().substr(1);
       return true;
     }},
    {"ADemonstrationThatIsMissing", "missing-demonstration",
     [](DamagedTask& s) {
       s.without_demonstration = true;
       return true;
     }},
    {"ADemonstrationOfAnotherMode", "stray-demonstration",
     [](DamagedTask& s) {
       s.demonstration["mode"] = "M2";
       return true;
     }},
    {"APoseChangedByADigit", "changes",
     [](DamagedTask& s) {
       for (auto& step : steps_of(s)) {
         if (!step["changes"].contains("agent")) continue;
         auto& x = step["changes"]["agent"]["position"][0];
         x = x.get<double>() + 1e-9;
         return true;
       }
       return false;
     }},
    {"ARelationThatDidNotEnd", "changes",
     [](DamagedTask& s) {
       for (auto& step : steps_of(s)) {
         if (step["changes"].contains("edges_removed") && step["changes"]["edges_removed"].size() > 1) {
           step["changes"]["edges_removed"].erase(0);
           return true;
         }
       }
       return false;
     }},
    {"ABoxThatIsAPixelWider", "view",
     [](DamagedTask& s) {
       for (auto& step : steps_of(s)) {
         if (step["visible"].empty()) continue;
         auto& right = step["visible"][0]["box"][2];
         right = right.get<int>() == 511 ? 510 : right.get<int>() + 1;
         return true;
       }
       return false;
     }},
    {"AStepLeftOut", "goal-not-reached",
     [](DamagedTask& s) {
       steps_of(s).erase(steps_of(s).size() - 2);  // the last before stop
       return true;
     }},
    {"AStepAfterTheEnd", "after-end",
     [](DamagedTask& s) {
       steps_of(s).push_back(steps_of(s).back());
       return true;
     }},
    {"NoStop", "no-stop",
     [](DamagedTask& s) {
       steps_of(s).erase(steps_of(s).size() - 1);
       return true;
     }},
    {"AnotherCountOfSteps", "step-count",
     [](DamagedTask& s) {
       s.task["expert"]["M1"]["steps"] = s.task["expert"]["M1"]["steps"].get<int>() + 1;
       return true;
     }},
    {"AGoalThatDoesNotRead", "goal-text",
     [](DamagedTask& s) {
       s.set_goal("[" + s.goal().substr(1));
       return true;
     }},
    {"AGoalsTreeOfAnotherCategory", "goal-tree",
     [](DamagedTask& s) {
       auto text = s.task["goal"]["tree"].dump();
       const std::string mark = "\"category\":\"";
       const auto at = text.find(mark);
       if (at == std::string::npos) return false;
       text.insert(at + mark.size(), "x");
       s.task["goal"]["tree"] = Json::parse(text);
       return true;
     }},
    {"AGoalTurnedIntoItsOpposite", "goal-at-start",
     [](DamagedTask& s) {
       s.set_goal("(not " + s.goal() + ")");
       return true;
     }},
    {"AGoalThatIsNotReached", "goal-not-reached",
     [](DamagedTask& s) { return extend_goal(s, "(at-end (forall (?z - object) (held ?z)))"); }},
    {"APartThatHoldsAtTheStart", "part-at-start",
     [](DamagedTask& s) {
       return extend_goal(s, "(at-end (exists (?z - object) (exists (?zr - room) (in_room ?z ?zr))))");
     }},
    {"AGoalAboutWhatIsNotThere", "empty-domain",
     [](DamagedTask& s) { return extend_goal(s, "(at-end (forall (?z - unicorn) (held ?z)))"); }},
    {"AGoalAboutAnUnknownCategory", "binding",
     [](DamagedTask& s) { return extend_goal(s, "(at-end (not (exists (?z - unicorn) (dirty ?z))))"); }},
    {"ABindingOfWhatNobodySpeaksOf", "binding",
     [](DamagedTask& s) {
       s.task["bindings"]["A"] = "unicorn";
       return true;
     }},
    {"AStartConstraintThatDoesNotHold", "start-constraint",
     [](DamagedTask& s) {
       s.task["start"]["constraints"].push_back("(forall (?z - object) (held ?z))");
       return true;
     }},
    {"AStartConstraintThatDoesNotRead", "start-constraint",
     [](DamagedTask& s) {
       s.task["start"]["constraints"].push_back("(forall ?z)");
       return true;
     }},
    {"AReferringPhraseOfNothing", "no-referent",
     [](DamagedTask& s) {
       return change_where(s, [](const std::string& f) { return "(and " + f + " (not " + f + "))"; });
     }},
    {"AReferringPhraseOfEverything", "no-distractor",
     [](DamagedTask& s) {
       return change_where(s, [](const std::string& f) { return "(or " + f + " (not " + f + "))"; });
     }},
    {"ADistractorThatServes", "distractor-serves",
     [](DamagedTask& s) {
       const auto goal = s.goal();
       const auto where = where_in(goal);
       const auto* step = s.last_step({"pick_up"});
       if (!where || step == nullptr || !another_lies_open(s, (*step)["args"][0])) return false;
       const auto referred = "(" + s.category_of((*step)["args"][0]) + " :where ";
       if (!goal.substr(0, where->from).ends_with(referred)) return false;
       const bool walks = step != &steps_of(s).front() && (*(step - 1))["action"] == "go_to" &&
                          (*(step - 1))["args"] == (*step)["args"];  // so that it also walks to the other one
       if (!walks) return false;
       const auto f = goal.substr(where->from, where->to - where->from);
       s.set_goal("(or " + goal + " " + goal.substr(0, where->from) + "(not " + f + ")" + goal.substr(where->to) + ")");
       return true;
     }},
    {"ASearchInM1", "search-mark",
     [](DamagedTask& s) {
       steps_of(s).front()["search"] = true;
       return true;
     }},
    {"AStepThatDoesNotTidyUp", "tidying-mark",
     [](DamagedTask& s) {
       if (steps_of(s).front().contains("tidying")) return false;
       steps_of(s).front()["tidying"] = true;
       return true;
     }},
    {"ATidyingStepWithoutItsMark", "tidying-mark",
     [](DamagedTask& s) {
       std::size_t unmarked = 0;
       for (Json& step : steps_of(s)) unmarked += step.erase("tidying");
       return unmarked > 0;
     }},
    {"ACountOfTidyingStepsThatIsWrong", "shortest-plan",
     [](DamagedTask& s) {
       s.task["expert"]["M1"]["shortest_steps"] = 49;
       return true;
     }},
    {"AShortestPlanInM1", "shortest-plan",
     [](DamagedTask& s) {
       s.demonstration["shortest"] = Json::array({{{"action", "stop"}, {"args", Json::array()}}});
       return true;
     }},
    {"ATemptingPlanWithoutAConstraint", "tempting-plan",
     [](DamagedTask& s) {
       if (s.demonstration.contains("tempting")) return false;
       s.demonstration["tempting"] = Json::array({{{"action", "stop"}, {"args", Json::array()}}});
       return true;
     }},
    {"ATemptingPlanThatIsMissing", "tempting-plan",
     [](DamagedTask& s) { return s.demonstration.erase("tempting") > 0; }},
    {"ATemptingPlanThatBreaksNothing", "tempting-plan",
     [](DamagedTask& s) {
       if (!s.demonstration.contains("tempting")) return false;
       Json plan = Json::array();
       for (const Json& step : steps_of(s)) plan.push_back({{"action", step["action"]}, {"args", step["args"]}});
       s.demonstration["tempting"] = std::move(plan);
       return true;
     }},
    {"ATemptingPlanWithADetour", "tempting-plan",
     [](DamagedTask& s) {
       if (!s.demonstration.contains("tempting")) return false;
       Json& plan = s.demonstration["tempting"];
       plan.insert(plan.begin(), plan.front());
       return true;
     }},
    {"AStepThatIsNotNeeded", "needless-step", [](DamagedTask& s) { return ask_for_less(s, "go_to"); }},
    {"SomethingThatMayStayInTheHand", "left-in-hand", [](DamagedTask& s) { return ask_for_less(s, "place_on"); }},
    {"AnOrderThatDoesNotMatter", "any-order",
     [](DamagedTask& s) {
       // What was picked up from where it lies was held, whether what is done after putting it down comes first or not.
       const auto& steps = steps_of(s);
       int picked = 0;
       std::size_t put = 0;
       for (std::size_t i = 0; i < steps.size(); ++i) {
         const std::string action = steps[i]["action"];
         picked += action == "pick_up" ? 1 : 0;
         if (put == 0 && action.starts_with("place_")) put = i;
       }
       if (picked != 1 || steps.size() < 4 || steps[1]["action"] != "pick_up" || steps[0]["args"] != steps[1]["args"])
         return false;
       const bool goes_on = put > 0 && put + 2 < steps.size() && steps[put + 1]["action"] != "go_to";
       if (!goes_on) return false;
       s.set_goal(
           "(or (exists (?z - " + s.category_of(steps[1]["args"][0]) +
           ") (sometime (held ?z))) (before (exists (?z - object) (held ?z)) (exists (?z - object) (held ?z))))");
       return true;
     }},
    {"ATaskInAHomeThatIsNotThere", "unreadable",
     [](DamagedTask& s) {
       s.task["layout"] = "elsewhere";
       return true;
     }},
    {"AChangeOfSomethingThatIsNotThere", "unreadable",
     [](DamagedTask& s) {
       s.home["nodes"].push_back({{"id", "unicorn_1"}});
       return true;
     }},
    {"ATaskOnAnotherSimulator", "scene-name",
     [](DamagedTask& s) {
       s.task["simulator"] = s.task["simulator"] == "habitat" ? "behavior" : "habitat";
       return true;
     }},
    {"SomethingInTheAir", "unrest",
     [](DamagedTask& s) {
       for (auto& node : s.scene["nodes"]) {
         if (!node["movable"].get<bool>()) continue;
         auto& height = node["position"][2];
         height = height.get<double>() + 0.4;
         return true;
       }
       return false;
     }},
    {"ARelationThatIsNotSaid", "relations",
     [](DamagedTask& s) {
       s.scene["edges"].erase(0);
       return true;
     }},
    {"ARelationThatIsNotThere", "relations",
     [](DamagedTask& s) {
       for (auto& edge : s.scene["edges"]) {
         if (edge["relation"] != "in_room") continue;
         for (const auto& room : s.scene["rooms"]) {
           if (room["id"] == edge["to"]) continue;
           edge["to"] = room["id"];
           return true;
         }
       }
       return false;
     }},
    {"ASceneWithAnUnknownCategory", "unbuildable",
     [](DamagedTask& s) {
       s.scene["nodes"].back()["category"] = "unicorn";
       return true;
     }},
    {"ASceneOfAnotherName", "task-name",
     [](DamagedTask& s) {
       s.task["scene"] = "elsewhere";
       return true;
     }},
    {"AnEditThatWasNotMade", "edits",
     [](DamagedTask& s) {
       s.task["start"]["edits"].push_back("added Unicorn unicorn_1 on table_1");
       return true;
     }},
    {"APurposeThatItsTemplateDoesNotGive", "template",
     [](DamagedTask& s) {
       s.task["purpose"]["name"] = s.task["purpose"]["name"] == "leisure" ? "safety" : "leisure";
       return true;
     }},
    {"AReasonThatItsTemplateDoesNotGive", "template",
     [](DamagedTask& s) {
       s.task["purpose"]["because"].push_back("somebody likes it");
       return true;
     }},
    {"AGradeThatTheGoalDoesNotHave", "sense",
     [](DamagedTask& s) {
       s.task["sense"]["grade"] = s.task["sense"]["grade"] == "usual" ? "tolerable" : "usual";
       return true;
     }},
    {"AReasonForTheGradeThatIsNotGiven", "sense",
     [](DamagedTask& s) {
       auto& parts = s.task["sense"]["parts"];
       if (!parts.empty()) parts[0]["why"] = "somebody thinks so";
       return !parts.empty();
     }},
    {"AMoveToAndFro", "edits",
     [](DamagedTask& s) {
       auto& edits = s.task["start"]["edits"];
       const auto moved = std::find_if(edits.begin(), edits.end(),
                                       [](const Json& edit) { return edit.get<std::string>().starts_with("moved "); });
       if (moved == edits.end()) return false;
       const Json again = *moved;
       edits.push_back(again);
       return true;
     }},
    {"AStateThatWasNotMade", "edits",
     [](DamagedTask& s) {
       for (auto& edit : s.task["start"]["edits"]) {
         const auto text = edit.get<std::string>();
         if (!text.starts_with("made ") || !text.ends_with(" dirty")) continue;
         edit = text.substr(0, text.size() - 5) + "clean";
         return true;
       }
       return false;
     }},
    {"ARefinementThatWasNotMade", "template",
     [](DamagedTask& s) {
       if (s.task["refinement"] != "") return false;
       s.task["refinement"] = "by-room";
       return true;
     }},
    {"ACheckThatWasNotMade", "text-record",
     [](DamagedTask& s) {
       s.task["instruction"]["checks"].push_back("judged-back");
       return true;
     }},
    {"NoWords", "no-text",
     [](DamagedTask& s) {
       s.task["instruction"]["text"] = " ";
       return true;
     }},
    {"AnIdInTheText", "text-form",
     [](DamagedTask& s) {
       const std::string text = s.task["instruction"]["text"], id = s.scene["nodes"][0]["id"];
       s.task["instruction"]["text"] = text + " Look at " + id + ".";
       return true;
     }},
    {"MarkupInTheText", "text-form",
     [](DamagedTask& s) {
       s.task["instruction"]["text"] = "**" + s.task["instruction"]["text"].get<std::string>() + "**";
       return true;
     }},
    {"ATextThatAsksForMore", "text-meaning",
     [](DamagedTask& s) {
       s.task["instruction"]["text"] = s.task["instruction"]["text"].get<std::string>() + " Also open every window.";
       return true;
     }},
    {"ATextOfAnotherGoal", "text-meaning",
     [](DamagedTask& s) {
       s.task["instruction"]["text"] = "Please keep every door closed the whole time.";
       return true;
     }},
    {"AStyleThatTheTextLacks", "text-style",
     [](DamagedTask& s) {
       const std::string text = s.task["instruction"]["text"];
       if (s.task["instruction"]["style"] != "direct" || has_size(text, 15)) return false;
       s.task["instruction"]["style"] = "exception";
       return true;
     }},
};

}  // namespace unietp
