#include "sense/goal_sketch.h"

#include <algorithm>
#include <mutex>
#include <shared_mutex>
#include <unordered_map>
#include <utility>

namespace unietp {
namespace {

void append_number(std::string& key, std::size_t number) {
  for (int byte = 0; byte < 4; ++byte) key += static_cast<char>((number >> (8 * byte)) & 0xffU);
}

void append_want(std::string& key, const Want& want) {
  append_number(key, static_cast<std::size_t>(want.predicate) * 2 + (want.negated ? 1 : 0));
  append_number(key, want.thing);
  append_number(key, want.other ? *want.other + 1 : 0);
  key.append(want.symbol) += '\n';
}

/// The name with what is bound to it; itself when nothing is.
void fill_in(std::string& name, std::span<const GoalSketch::Bound> bound, const GoalSketch::Bound& next) {
  for (const auto& [placeholder, value] : bound) {
    if (placeholder != name) continue;
    name = value;
    return;
  }
  if (next.first == name) name = next.second;
}

}  // namespace

struct PieceGrades::Table {
  std::shared_ptr<const SenseTables> tables;
  std::unordered_map<std::string, std::size_t> alike;  // category -> number of all that are graded like it
  std::shared_mutex mutex;
  std::unordered_map<std::string, Grade> grades;  // by piece; never iterated

  Table(const Knowledge& knowledge, std::shared_ptr<const SenseTables> all) : tables(std::move(all)) {
    const CommonSense& sense = tables->common;
    std::unordered_map<std::string, std::size_t> numbers;
    for (const Category& category : knowledge.categories()) {
      const auto* fact = sense.kind_of(knowledge.simulator(), category.name);
      if (fact == nullptr) continue;
      std::string looks = fact->kind;
      const auto& of = category.materials;  // a rule speaks of things that come in one material alone
      const bool alone =
          !of.empty() && std::all_of(of.begin(), of.end(), [&](const auto& one) { return one == of[0]; });
      if (alone && sense.has_rule_on(of[0])) looks += "\n" + of[0];
      if (sense.has_rule_on_name(category.display)) looks += "\n\n" + category.display;
      alike[category.name] = numbers.try_emplace(looks, numbers.size()).first->second;
    }
  }

  std::string key_of(const Wants& piece) const {
    std::string key;
    for (const Want& want : piece.wants) append_want(key, want);
    key += '|';
    for (const Want& want : piece.found) append_want(key, want);
    for (std::size_t i = 0; i < piece.things.size(); ++i) {
      const Domain& domain = piece.things[i];
      key += piece.single[i] ? '1' : 'n';
      key += static_cast<char>('0' + static_cast<int>(domain.kind));
      for (const auto& member : domain.members) {
        key += member.slice ? '/' : ' ';
        const auto known = alike.find(member.category);
        if (known == alike.end())
          key.append(member.category) += '\n';
        else
          append_number(key, known->second);
      }
    }
    return key;
  }
};

PieceGrades::PieceGrades(const Knowledge& knowledge, std::shared_ptr<const SenseTables> tables)
    : table_(std::make_shared<Table>(knowledge, std::move(tables))) {}

Grade PieceGrades::grade(const Wants& piece, const Knowledge& knowledge) const {
  const auto key = table_->key_of(piece);
  {
    const std::shared_lock lock(table_->mutex);
    if (const auto found = table_->grades.find(key); found != table_->grades.end()) return found->second;
  }
  const SenseTables& tables = *table_->tables;
  const Grade grade = grade_piece(piece, knowledge, tables.common, tables.words).value_or(Grade::Usual);
  const std::unique_lock lock(table_->mutex);
  return table_->grades.emplace(key, grade).first->second;
}

GoalSketch::GoalSketch(const Formula& goal, const std::vector<std::string>& placeholders, const PieceGrades& grades,
                       const Knowledge& knowledge)
    : first_(placeholders.empty() ? "" : placeholders.front()), grades_(grades), knowledge_(&knowledge) {
  for (auto& wants : pieces_of(wants_of(goal))) {
    Piece piece{std::move(wants), {}};
    const auto note = [&](const std::string& name) {
      const bool placeholder = std::find(placeholders.begin(), placeholders.end(), name) != placeholders.end();
      const auto& known = piece.placeholders;
      if (placeholder && std::find(known.begin(), known.end(), name) == known.end()) piece.placeholders.push_back(name);
    };
    for (const auto& domain : piece.wants.things) {
      for (const auto& member : domain.members) note(member.category);
    }
    for (const auto* list : {&piece.wants.wants, &piece.wants.found}) {
      for (const Want& want : *list) note(want.symbol);
    }
    pieces_.push_back(std::move(piece));
  }
}

Grade GoalSketch::grade_of_step(std::span<const Bound> bound, const Bound& next) const {
  Grade worst = Grade::Usual;
  const auto is_bound = [&](const std::string& name) {
    return name == next.first ||
           std::any_of(bound.begin(), bound.end(), [&](const Bound& one) { return one.first == name; });
  };
  for (const Piece& piece : pieces_) {
    const auto& names = piece.placeholders;
    const bool decides = names.empty() ? next.first == first_
                                       : std::find(names.begin(), names.end(), next.first) != names.end() &&
                                             std::all_of(names.begin(), names.end(), is_bound);
    if (!decides) continue;
    Wants filled = piece.wants;
    for (auto& domain : filled.things) {
      for (auto& member : domain.members) fill_in(member.category, bound, next);
    }
    for (auto* list : {&filled.wants, &filled.found}) {
      for (Want& want : *list) fill_in(want.symbol, bound, next);
    }
    worst = std::min(worst, grades_.grade(filled, *knowledge_));
    if (worst == Grade::Senseless) break;
  }
  return worst;
}

}  // namespace unietp
