#include "sense/common_sense.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/text.h"

namespace unietp {
namespace {

constexpr double kUsual = 0.5, kTolerable = 0.12;        // least score of each grade
constexpr double kMostOfTolerable = 0.49;                // of what a person did not judge usual
constexpr std::array<double, 3> kStart{0.02, 0.3, 1.0};  // by grade
constexpr double kUnjudged = 0.05, kNeutral = 0.3;       // at the root; for what nobody asks about
constexpr double kUsualShare = 0.08, kMostWritten = 15, kPrior = 20;
constexpr double kMostOfPlaces = 0.9, kMostOfDeeds = 0.75;
constexpr double kRise = 0.6, kRiseAgainstJudgment = 0.5;  // of what was senseless
constexpr double kSharedPlace = 0.6;                       // next to one another is less usual than at the place itself

Grade grade_of(double score) {
  return score >= kUsual ? Grade::Usual : score >= kTolerable ? Grade::Tolerable : Grade::Senseless;
}

constexpr std::string_view kNextTo = "next_to:", kMaterialMark = "material:", kOnFloor = "on:floor",
                           kInRoom = "in_room:";

/// True for roles that are not wrong only because nobody spoke of them.
bool is_neutral(std::string_view role) { return role.find('>') != std::string_view::npos || role.starts_with(kInRoom); }

bool matches(std::string_view pattern, std::string_view role) {
  if (!pattern.ends_with('*')) return pattern == role;
  return role.starts_with(pattern.substr(0, pattern.size() - 1));
}

Sense refused_by(const SenseRule& rule) {
  return {Grade::Senseless, 0, {"rule " + rule.name + ": " + rule.reason}, "rule:" + rule.name};
}

std::string short_number(double value) { return number_text(static_cast<double>(std::lround(value * 100)) / 100); }

}  // namespace

Sense worse_of(Sense a, Sense b) {
  if (a.grade == b.grade) {
    a.score = std::min(a.score, b.score);
    for (auto& reason : b.reasons) {
      if (std::find(a.reasons.begin(), a.reasons.end(), reason) == a.reasons.end())
        a.reasons.push_back(std::move(reason));
    }
    return a;
  }
  return a.grade < b.grade ? a : b;
}

CommonSense::CommonSense(Kinds kinds, CategoryKinds categories, Judgments judgments, std::vector<SenseRule> rules,
                         const std::vector<Evidence>& evidence, SpecialPlaces special, Companions companions,
                         PlaceUses uses, GenericWords generic)
    : kinds_(std::move(kinds)),
      categories_(std::move(categories)),
      judgments_(std::move(judgments)),
      rules_(std::move(rules)),
      evidence_(evidence),
      special_(std::move(special)),
      companions_(std::move(companions)),
      uses_(std::move(uses)),
      generic_(std::move(generic)) {
  for (const auto& [of, grade] : judgments_) {
    if (of.second.starts_with(kInRoom)) in_rooms_.insert(of.second);
  }
  for (std::size_t i = 0; i < evidence_.size(); ++i) {
    const Evidence& row = evidence_[i];
    for (const Kind* kind : kinds_.lineage(row.thing)) {
      const auto [found, first] = counts_.try_emplace({kind->name, row.role}, Count{0, i});
      Count& count = found->second;
      count.weight += row.weight;
      if (row.weight > evidence_[count.best].weight) count.best = i;
      totals_[{kind->name, family_of(row.role)}] += row.weight;
    }
  }
}

const KindFact* CommonSense::kind_of(Simulator simulator, const std::string& category) const {
  const auto found = categories_.find({simulator, category});
  return found == categories_.end() ? nullptr : &found->second;
}

double CommonSense::score(const std::string& kind, const Role& role) const {
  const auto judged = judgments_.find({kind, role});
  const Kind* known = kinds_.find(kind);
  const bool root = known == nullptr || known->parent.empty();
  const Grade* grade = judged == judgments_.end() ? nullptr : &judged->second;
  const double start = grade != nullptr ? kStart[static_cast<std::size_t>(*grade)]
                       : root           ? (is_neutral(role) ? kNeutral : kUnjudged)
                                        : score(known->parent, role);
  // The root and the kinds below it are too wide for what people write of one thing to say something of another.
  if (root || kinds_.lineage(kind).size() <= 2) return start;
  const double value = moved(kind, role, start, grade);
  const bool refused = grade != nullptr && *grade == Grade::Senseless;
  return value >= kUsual && (refused || is_judged_tolerable(kind, role)) ? kMostOfTolerable : value;
}

bool CommonSense::is_judged_tolerable(const std::string& kind, const Role& role) const {
  for (const Kind* each : kinds_.lineage(kind)) {
    if (kinds_.lineage(each->name).size() <= 2) return false;
    const auto judged = judgments_.find({each->name, role});
    if (judged != judgments_.end()) return judged->second == Grade::Tolerable;
  }
  return false;
}

double CommonSense::moved(const std::string& kind, const Role& role, double start, const Grade* judged) const {
  const auto family = family_of(role);
  const auto total = totals_.find({kind, family});
  const bool spoken_of = counts_.contains({kinds_.all().front().name, role});
  if (total == totals_.end() || !spoken_of) return start;
  const auto count = counts_.find({kind, role});
  const bool sequence = family.ends_with('>');
  if (count == counts_.end() && (sequence || judged == nullptr)) return start;
  const double share = count == counts_.end() ? 0 : count->second.weight / total->second;
  const double shown = std::min(family == "place" ? kMostOfPlaces : kMostOfDeeds, share / kUsualShare);
  const double written = std::min(kMostWritten, total->second);
  const double value = (written * shown + kPrior * start) / (written + kPrior);
  if (value <= start || start >= kTolerable) return value;
  const bool refused = judged != nullptr && *judged == Grade::Senseless;
  return start + (value - start) * (refused ? kRiseAgainstJudgment : kRise);
}

bool CommonSense::meets(const SenseRule& rule, const Thing& thing) const {
  for (const auto& kind : rule.except) {
    if (kinds_.is_a(thing.kind, kind)) return false;
  }
  if (!rule.words.empty()) return rule.words.contains(normal_word(thing.words));
  if (!rule.thing.starts_with(kMaterialMark)) return kinds_.is_a(thing.kind, rule.thing);
  const auto of = rule.thing.substr(kMaterialMark.size());
  return !thing.materials.empty() && std::all_of(thing.materials.begin(), thing.materials.end(),
                                                 [&](const std::string& each) { return each == of; });
}

Role CommonSense::known_role(const Thing& thing, const Role& role) const {
  const auto mark = role.find(':');
  const auto word = role.substr(0, mark);
  if (mark == std::string::npos || (word != "cover" && word != "uncover" && word != "fill")) return role;
  // The nearest kind of the substance that somebody spoke of together with the thing.
  const auto things = kinds_.lineage(thing.kind);
  for (const Kind* substance : kinds_.lineage(role.substr(mark + 1))) {
    Role wider = word + ":" + substance->name;
    for (const Kind* kind : things) {
      if (judgments_.contains({kind->name, wider})) return wider;
    }
  }
  return role;
}

std::vector<std::string> CommonSense::reasons_for(const Thing& thing, const Role& role) const {
  std::vector<std::string> reasons;
  for (const Kind* kind : kinds_.lineage(thing.kind)) {
    const auto judged = judgments_.find({kind->name, role});
    if (judged == judgments_.end()) continue;
    reasons.push_back("judged " + std::string(name_of(judged->second)) + " for " + kind->plural + ": " + role);
    break;
  }
  for (const Kind* kind : kinds_.lineage(thing.kind)) {
    if (kinds_.lineage(kind->name).size() <= 2) break;
    const auto total = totals_.find({kind->name, family_of(role)});
    if (total == totals_.end()) continue;
    const auto count = counts_.find({kind->name, role});
    const double weight = count == counts_.end() ? 0 : count->second.weight;
    std::string text =
        "written of " + kind->plural + ": " + short_number(weight) + " of " + short_number(total->second);
    if (weight > 0) {
      const Evidence& row = evidence_[count->second.best];
      text += ", such as '" + row.example + "' [" + row.source + "]";
    }
    reasons.push_back(std::move(text));
    break;
  }
  if (reasons.empty()) reasons.push_back("nobody wrote or judged that of such a thing: " + role);
  return reasons;
}

/// Of a place of a wide kind, the narrower one that suits the thing best; the role itself when none suits it better.
Role CommonSense::best_place(const std::string& kind, const Role& role) const {
  const auto mark = role.rfind(':');
  if (mark == Role::npos || role.rfind(kNextTo) != Role::npos) return role;
  const auto* place = kinds_.find(role.substr(mark + 1));
  if (place == nullptr || place->relation.empty()) return role;
  Role best = role;
  double most = score(kind, role);
  for (const Kind* narrow : kinds_.narrower(place->name)) {
    const Role other = role.substr(0, mark + 1) + narrow->name;
    const double value = score(kind, other);
    if (value <= most) continue;
    most = value;
    best = other;
  }
  return best;
}

Sense CommonSense::graded(const Thing& thing, const Role& asked) const {
  const Role role = best_place(thing.kind, asked);
  const double value = score(thing.kind, role);
  return {grade_of(value), value, reasons_for(thing, role), std::string(why(thing, role))};
}

std::string_view CommonSense::why(const Thing& thing, const Role& role) const {
  bool judged = false;
  for (const Kind* kind : kinds_.lineage(thing.kind)) {
    if (kinds_.lineage(kind->name).size() > 2 && counts_.contains({kind->name, role})) return "written";
    judged = judged || judgments_.contains({kind->name, role});
  }
  return judged ? "judged" : kUnspoken;
}

Sense CommonSense::beside(const Thing& thing, const Role& role, const std::string& other) const {
  Sense own = graded(thing, role);
  double best = 0;
  std::string where;
  const auto offer = [&](double value, const std::string& what) {
    if (value > best) {
      best = value;
      where = what;
    }
  };
  // What stands on furniture, a lamp or a toaster, has others beside it there.
  for (const auto& place : kinds_.all()) {
    if (place.relation.empty() || !kinds_.is_a(place.name, "place")) continue;
    const Role at = kinds_.place_role(kinds_.usual_relation(place.name), place.name);
    const bool floor = !kinds_.is_a(other, "movable") && at == kOnFloor;
    offer(kSharedPlace * std::min(score(thing.kind, at), floor ? 1 : score(other, at)), at);
  }
  if (!kinds_.is_a(other, "movable")) {
    for (const auto* relation : {"on", "in"}) {
      const Role at = best_place(thing.kind, kinds_.place_role(relation, other));
      if (grade_of(score(thing.kind, at)) != Grade::Senseless) offer(kStart[1], at);
    }
  }
  if (best <= own.score) return own;
  return {grade_of(best), best, {"both may be at one place: " + where}, "shared"};
}

bool CommonSense::has_rule_on(std::string_view material) const {
  return std::any_of(rules_.begin(), rules_.end(), [&](const SenseRule& rule) {
    return rule.thing.starts_with(kMaterialMark) && rule.thing.substr(kMaterialMark.size()) == material;
  });
}

bool CommonSense::has_rule_on_name(std::string_view words) const {
  const auto word = normal_word(words);
  if (generic_.contains(words)) return true;
  return std::any_of(rules_.begin(), rules_.end(), [&](const SenseRule& rule) { return rule.words.contains(word); });
}

bool CommonSense::may_mean(const Thing& name, const Thing& thing) const {
  return name.words != thing.words && generic_.may_mean(name.words, thing.kind, kinds_);
}

const SenseRule* CommonSense::broken(const Thing& thing, const Role& role) const {
  for (const auto& rule : rules_) {
    if (!rule.together && !rule.stored && matches(rule.other, role) && meets(rule, thing)) return &rule;
  }
  return nullptr;
}

Sense CommonSense::grade(const Thing& thing, const Role& asked) const {
  const Role role = known_role(thing, asked);
  if (const auto* rule = broken(thing, role)) return refused_by(*rule);
  if (role.starts_with(kNextTo)) return beside(thing, role, role.substr(kNextTo.size()));
  return graded(thing, role);
}

Sense CommonSense::found(const Thing& thing, const Role& place) const {
  if (const auto* rule = broken(thing, "found:" + place)) return refused_by(*rule);
  return {Grade::Usual, 1, {}, ""};
}

Sense CommonSense::alone(const Thing& thing) const {
  if (const auto* rule = broken(thing, "single")) return refused_by(*rule);
  return {Grade::Usual, 1, {}, ""};
}

Sense CommonSense::near(const Thing& thing, const Thing& landmark) const {
  for (const Role& room : in_rooms_) {
    if (grade(thing, room).grade == Grade::Usual && grade(landmark, room).grade == Grade::Usual)
      return {Grade::Usual, 1, {"both are usual " + room}, "shared"};
  }
  return {Grade::Tolerable, kNeutral, {"the two are usual in no room together"}, "apart"};
}

bool CommonSense::belongs(const Thing& thing, const std::string& place) const {
  for (const auto* relation : {"in", "on"}) {
    const Role at = best_place(thing.kind, kinds_.place_role(relation, place));
    if (grade_of(score(thing.kind, at)) != Grade::Senseless) return true;
  }
  return false;
}

std::string CommonSense::place_in_room(std::string_view place, std::string_view room) const {
  const Role there = std::string(kInRoom).append(room);
  for (const Kind* narrower : kinds_.narrower(place)) {
    const auto judged = judgments_.find({narrower->name, there});
    if (judged != judgments_.end() && judged->second == Grade::Usual) return narrower->name;
  }
  return "";
}

std::vector<std::pair<std::string, std::string>> CommonSense::kept_apart() const {
  std::vector<std::pair<std::string, std::string>> pairs;
  for (const auto& rule : rules_) {
    if (rule.together) pairs.emplace_back(rule.thing, rule.other);
  }
  return pairs;
}

CommonSense::StoredApart CommonSense::stored_apart(const Thing& thing) const {
  StoredApart found;
  for (std::size_t i = 0; i < rules_.size(); ++i) {
    if (!rules_[i].stored) continue;
    if (meets(rules_[i], thing)) found.one.push_back(i);
    if (kinds_.is_a(thing.kind, rules_[i].other)) found.other.push_back(i);
  }
  return found;
}

Sense CommonSense::together(const Thing& a, const Thing& b) const {
  for (const auto& rule : rules_) {
    if (!rule.together) continue;
    for (const auto& [first, second] : {std::pair(&a, &b), std::pair(&b, &a)}) {
      if (meets(rule, *first) && kinds_.is_a(second->kind, rule.other)) return refused_by(rule);
    }
  }
  return {Grade::Usual, 1, {}, ""};
}

CommonSense read_common_sense(const std::filesystem::path& folder, std::vector<Error>& errors) {
  Kinds kinds = read_kinds(folder / "kinds.csv", errors);
  auto categories = read_category_kinds(folder / "categories.csv", kinds, errors);
  auto judgments = read_judgments(folder / "judged.csv", kinds, errors);
  auto rules = read_sense_rules(folder / "rules.csv", kinds, errors);
  const auto evidence = read_evidence(folder / "counts.csv", kinds, errors);
  auto special = read_special_places(folder / "special_places.csv", kinds, errors);
  auto companions = read_companions(folder / "companions.csv", kinds, errors);
  auto uses = read_place_uses(folder / "place_uses.csv", kinds, errors);
  auto generic = read_generic_words(folder / "generic_words.csv", kinds, errors);
  return {std::move(kinds),   std::move(categories), std::move(judgments), std::move(rules),  evidence,
          std::move(special), std::move(companions), std::move(uses),      std::move(generic)};
}

}  // namespace unietp
