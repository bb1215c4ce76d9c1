#include <algorithm>
#include <optional>

#include "akb/fact_values.h"
#include "akb/fit.h"
#include "akb/name_table.h"
#include "akb/override.h"
#include "akb/table_words.h"
#include "core/limits.h"
#include "core/text.h"
#include "scene/simulator.h"

namespace unietp {
namespace {

template <class Row, class Test>
Row* row_where(std::vector<Row>& rows, const Test& test) {
  const auto at = std::find_if(rows.begin(), rows.end(), test);
  return at == rows.end() ? nullptr : &*at;
}

/// Lays the overrides of one simulator over its tables.
class Overlay {
 public:
  Overlay(std::string where, Simulator simulator, Tables& tables, std::vector<Error>& errors)
      : where_(std::move(where)), simulator_(simulator), tables_(tables), errors_(errors) {
    std::vector<std::string> names;
    for (const auto& c : tables_.categories) names.push_back(c.name);
    names_ = NameTable(std::move(names));
    source_ = {override_source(where_), 1};
  }

  void apply(const Override& o) {
    override_ = &o;
    subject_ = category(o.category, o.category_at);
    if (subject_ == nullptr) return;
    switch (o.fact.kind) {
      case FactName::Kind::Property:
        return property();
      case FactName::Kind::Affordance:
        return affordance();
      case FactName::Kind::Placement:
        return placement();
      case FactName::Kind::Effect:
        return effect();
      case FactName::Kind::Alias:
        return alias();
      case FactName::Kind::Asset:
        return asset();
    }
  }

 private:
  void fail(SourcePos at, std::string message) {
    errors_.push_back({Error::Kind::Schema, where_, at, std::move(message)});
  }
  void bad_value(std::string_view expected) {
    fail(override_->value_at,
         "bad value '" + override_->value + "' of " + to_text(override_->fact) + "; expected " + std::string(expected));
  }
  Category* category(const std::string& name, SourcePos at) {
    if (names_.contains(name)) return row_where(tables_.categories, [&](const Category& c) { return c.name == name; });
    const auto near = nearest_name(name, names_.names());
    fail(at, std::string(name_of(simulator_)) + " has no category '" + name + "'" +
                 (near.empty() ? "" : "; did you mean '" + near + "'?"));
    return nullptr;
  }

  void property() {
    const auto& word = override_->fact.word;
    const auto& value = override_->value;
    Category& c = *subject_;
    if (word == "size") {
      const auto size = size_in(value);
      if (!size) return bad_value("width, depth and height in meters, each > 0 and <= 100, such as 0.3 x 0.2 x 0.1");
      c.size = *size;
      c.size_source = source_;
    } else if (word == "mass") {
      const auto mass = number_in(value, limits::kCategory_kg);
      if (!mass) return bad_value("kilograms > 0 and <= 90000");
      c.mass = *mass;
      c.mass_source = source_;
    } else if (word == "movable") {
      const auto flag = flag_in(value);
      if (!flag) return bad_value("true or false");
      set_movable(*flag);
    } else if (word == "synset") {
      if (!value.empty() && !is_synset(value)) return bad_value("a WordNet synset such as mug.n.04, or nothing");
      c.synset = value;
      c.synset_source = source_;
    } else if (cell(c, word, value)) {
      c.source = source_;
    }
  }
  /// The properties that share the source of the category's row.
  bool cell(Category& c, const std::string& word, const std::string& value) {
    const auto words = [&](std::vector<std::string>& into, const std::vector<std::string>& accepted) {
      auto read = words_in(value, accepted);
      if (!read) {
        bad_value(accepted.empty() ? "words joined by |, or nothing"
                                   : "nothing or, joined by |, some of " + join(accepted, ", "));
        return false;
      }
      into = std::move(*read);
      return true;
    };
    if (word == "rooms") return words(c.rooms, room_types());
    if (word == "colours") return words(c.colors, {});
    if (word == "materials") return words(c.materials, {});
    if (word == "countable") {
      const auto flag = flag_in(value);
      if (!flag) return bad_value("true or false"), false;
      c.countable = *flag;
    } else if (word == "archetype") {
      const auto archetype = archetype_named(value);
      if (!archetype) {
        std::vector<std::string> names;
        for (const auto known : all_archetypes()) names.emplace_back(name_of(known));
        return bad_value("one of " + join(names, ", ")), false;
      }
      c.archetype = *archetype;
    } else {
      if (trim(value).empty() || trim(value) != value) return bad_value("a name without spaces around it"), false;
      (word == "plural" ? c.plural : c.display) = value;
    }
    return true;
  }

  void set_movable(bool movable) {
    subject_->movable = movable;
    subject_->source = source_;
    set_affordance("pickupable", movable);
  }
  void set_affordance(const std::string& affordance, bool holds) {
    const auto same = [&](const AffordanceFact& f) {
      return f.category == override_->category && f.affordance == affordance;
    };
    std::erase_if(tables_.affordances, same);
    if (holds) tables_.affordances.push_back({override_->category, affordance, source_});
  }
  void affordance() {
    const auto flag = flag_in(override_->value);
    if (!flag) return bad_value("true or false");
    if (override_->fact.word == "pickupable") return set_movable(*flag);
    set_affordance(override_->fact.word, *flag);
  }

  void placement() {
    const auto& fact = override_->fact;
    const Category* receptacle = category(fact.object, override_->fact_at);
    if (receptacle == nullptr) return;
    const auto relation = placement_relation_named(fact.word).value_or(Predicate::On);  // parse_fact accepts no other
    const auto same = [&](const Placement& p) {
      return p.object == override_->category && p.relation == relation && p.receptacle == fact.object;
    };
    Placement* row = row_where(tables_.placements, same);
    if (!fact.detail.empty()) return capacity(row);
    const auto flag = flag_in(override_->value);
    const auto likelihood = number_in(override_->value, 1);
    if (!flag && !likelihood) return bad_value("true, false or a likelihood > 0 and <= 1");
    if (flag && !*flag) {
      std::erase_if(tables_.placements, same);
      return;
    }
    if (row == nullptr) {
      const int fitting = std::max(1, capacity_of(*subject_, relation, *receptacle));
      tables_.placements.push_back({override_->category, relation, fact.object, usual_likelihood(), fitting, source_});
      row = &tables_.placements.back();
    }
    if (likelihood) row->likelihood = *likelihood;
    row->source = source_;
  }
  void capacity(Placement* row) {
    const auto count = count_in(override_->value);
    if (!count) return bad_value("a whole number >= 1");
    if (row == nullptr) return does_not_hold();
    row->capacity = *count;
    row->source = source_;
  }
  double usual_likelihood() const {
    double sum = 0, rows = 0;
    for (const auto& p : tables_.placements) {
      if (p.object == override_->category) sum += p.likelihood, ++rows;
    }
    return rows > 0 ? sum / rows : 1;
  }
  void does_not_hold() {
    FactName whole = override_->fact;
    whole.detail.clear();
    fail(override_->fact_at, "'" + to_text(whole) + "' does not hold, so it has no " + override_->fact.detail +
                                 "; expected a row before this one that makes it true");
  }

  void effect() {
    const auto& fact = override_->fact;
    if (category(fact.object, override_->fact_at) == nullptr) return;
    const auto treatment = treatment_named(fact.word).value_or(Treatment::Heats);  // parse_fact accepts no other
    const auto same = [&](const Effect& e) {
      return e.tool == override_->category && e.treatment == treatment && e.target == fact.object;
    };
    if (!fact.detail.empty()) return needs(same);
    const auto flag = flag_in(override_->value);
    if (flag && !*flag) {
      std::erase_if(tables_.effects, same);
      return;
    }
    Effect made{override_->category, treatment, fact.object, "", 0, usual_needs(treatment), source_};
    Effect* row = row_where(tables_.effects, same);
    if (treatment == Treatment::Slices) {
      if (!flag && !pieces(made)) return;
      if (flag && row == nullptr)
        return bad_value("a number of slices and their category, such as 5 AppleSliced, or false");
    } else if (!flag) {
      if (trim(override_->value).empty() || trim(override_->value) != override_->value)
        return bad_value("true, false or the name of the result");
      made.gives = override_->value;
    }
    if (flag && row != nullptr) {
      row->source = source_;
      return;
    }
    if (row != nullptr) made.needs = row->needs;
    std::erase_if(tables_.effects, same);
    tables_.effects.push_back(std::move(made));
  }
  bool pieces(Effect& made) {
    const auto blank = override_->value.find(' ');
    const auto count = count_in(std::string_view(override_->value).substr(0, blank));
    if (!count || blank == std::string::npos) {
      bad_value("a number of slices and their category, such as 5 AppleSliced, or false");
      return false;
    }
    made.amount = *count;
    made.gives = override_->value.substr(blank + 1);
    return category(made.gives, override_->value_at) != nullptr;
  }
  template <class Test>
  void needs(const Test& same) {
    auto words = words_in(override_->value, need_names());
    if (!words) return bad_value("nothing or, joined by |, some of " + join(need_names(), ", "));
    std::vector<EffectNeed> needs;
    for (const auto& word : *words) needs.push_back(effect_need_named(word).value());
    bool found = false;
    for (auto& e : tables_.effects) {
      if (!same(e)) continue;
      e.needs = needs;
      e.source = source_;
      found = true;
    }
    if (!found) does_not_hold();
  }
  std::vector<EffectNeed> usual_needs(Treatment treatment) const {
    for (const auto& e : tables_.effects) {
      if (e.tool == override_->category && e.treatment == treatment) return e.needs;
    }
    return {};
  }

  void alias() {
    const auto& text = override_->fact.object;
    const auto flag = flag_in(override_->value);
    const auto kind = flag ? std::optional(AliasKind::Synonym) : alias_kind_named(override_->value);
    if (!kind) return bad_value("true (a synonym), false or one of " + join(alias_kinds(), ", "));
    std::erase_if(tables_.aliases, [&](const Alias& a) { return a.category == override_->category && a.text == text; });
    if (!flag || *flag) tables_.aliases.push_back({override_->category, text, *kind, source_});
  }

  void asset() {
    const auto& name = override_->fact.object;
    const auto size = size_in(override_->value);
    if (!size && override_->value != "false") return bad_value("false, or its size in meters, such as 0.3 x 0.2 x 0.1");
    std::erase_if(tables_.assets, [&](const Asset& a) { return a.name == name; });
    if (size) tables_.assets.push_back({name, override_->category, *size, source_});
  }

  std::string where_;
  Simulator simulator_;
  Tables& tables_;
  std::vector<Error>& errors_;
  NameTable names_;
  Source source_;
  const Override* override_ = nullptr;
  Category* subject_ = nullptr;
};

}  // namespace

void apply_overrides(const std::string& where, const std::vector<Override>& overrides, std::vector<Tables>& all,
                     std::vector<Error>& errors) {
  for (std::size_t i = 0; i < all.size(); ++i) {
    Overlay overlay(where, kSimulators[i], all[i], errors);
    for (const auto& o : overrides) {
      if (o.simulator == kSimulators[i]) overlay.apply(o);
    }
  }
}

}  // namespace unietp
