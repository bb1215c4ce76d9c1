#include "akb/complete_answer.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "akb/fit.h"
#include "akb/phrases.h"
#include "akb/table_words.h"
#include "core/limits.h"
#include "core/text.h"
#include "llm/json_object.h"
#include "llm/redact.h"

namespace unietp {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kLongestShown = 60;
constexpr double kSmallest = 0.001;
constexpr double kLightest_kg_m3 = 0.5, kDensest_kg_m3 = 25000;  // of the box: a paper lantern, gold
constexpr std::size_t kMostPhrases = 4, kMostPlaces = 12;

bool opens(Archetype a) {
  return a == Archetype::Cabinet || a == Archetype::Drawers || a == Archetype::Lidded || a == Archetype::Folding;
}

/// What an answer is held against, prepared once.
struct Known {
  const Tables& tables;
  std::map<std::string, const Category*, std::less<>> categories;
  std::map<std::string, std::set<std::string, std::less<>>, std::less<>> affordances;
  std::map<std::string, std::set<std::string>, std::less<>> named;  // a name in English -> the categories it names

  explicit Known(const Tables& all) : tables(all) {
    for (const auto& c : all.categories) {
      categories.emplace(c.name, &c);
      named[c.display].insert(c.name);
      named[c.plural].insert(c.name);
    }
    for (const auto& f : all.affordances) affordances[f.category].insert(f.affordance);
    for (const auto& a : all.aliases) {
      if (a.kind == AliasKind::Synonym) named[a.text].insert(a.category);
    }
  }
};

/// Goes through the entry of one category.
class Entry {
 public:
  Entry(const Known& known, const Category& category, const Source& source, const WordNet* wordnet, CheckedAnswer& out)
      : known_(known), category_(category), source_(source), wordnet_(wordnet), out_(out) {}

  void take(FactKind kind, const Json& value) {
    kind_ = kind;
    switch (kind) {
      case FactKind::Size:
        return take_size(value);
      case FactKind::Mass:
        return take_mass(value);
      case FactKind::Synset:
        return take_synset(value);
      case FactKind::Aliases:
      case FactKind::Function:
      case FactKind::Context:
        return each(value, kMostPhrases, [&](const Json& item) { take_phrase(item); });
      case FactKind::Placements:
        return each(value, kMostPlaces, [&](const Json& item) { take_place(item); });
      case FactKind::Affordances:
        return each(value, affordance_names().size(), [&](const Json& item) { take_affordance(item); });
    }
  }

 private:
  void reject(const Json& value, std::string_view reason) {
    std::string text =
        value.is_string() ? value.get<std::string>() : value.dump(-1, ' ', true, Json::error_handler_t::replace);
    out_.rejected.push_back(
        {category_.name, std::string(name_of(kind_)), plain_line(text, kLongestShown), std::string(reason)});
  }

  template <class Take>
  void each(const Json& value, std::size_t most, const Take& take) {
    if (!value.is_array()) return reject(value, "not in the requested form");
    for (std::size_t i = 0; i < value.size(); ++i) {
      if (i >= most) {
        reject(value[i], "more than requested");
      } else {
        take(value[i]);
      }
    }
  }

  /// Rounded to a thousandth; nothing, and a rejection, when it is out of (0, most].
  std::optional<double> amount(const Json& whole, const Json& value, double most) {
    if (!value.is_number()) return reject(whole, "not in the requested form"), std::nullopt;
    const double number = value.get<double>();
    if (!std::isfinite(number) || number < kSmallest || number > most)
      return reject(whole, "out of bounds"), std::nullopt;
    return std::round(number * 1000) / 1000;
  }

  /// What the tables or this very entry say of size and mass must go together.
  bool possible(const Json& value, const Vec3& size, double mass) {
    const double density = mass / size.prod();
    if (density >= kLightest_kg_m3 && density <= kDensest_kg_m3) return true;
    reject(value, "not possible with its size and mass");
    return false;
  }

  void take_size(const Json& value) {
    Vec3 size = Vec3::Zero();
    int axis = 0;
    for (const char* side : {"width", "depth", "height"}) {
      if (!value.is_object() || !value.contains(side)) return reject(value, "not in the requested form");
      const auto extent = amount(value, value.at(side), limits::kCompleted_m);
      if (!extent) return;
      size[axis++] = *extent;
    }
    if (!possible(value, size, category_.mass)) return;
    out_.accepted.sizes.push_back({category_.name, size, source_});
  }

  void take_mass(const Json& value) {
    const auto mass = amount(value, value, limits::kCompleted_kg);
    if (mass && possible(value, category_.size, *mass))
      out_.accepted.masses.push_back({category_.name, *mass, source_});
  }

  void take_synset(const Json& value) {
    if (!value.is_string()) return reject(value, "not in the requested form");
    const auto& synset = value.get_ref<const std::string&>();
    if (synset.empty()) return;
    if (!synset_named(synset) || synset.size() > 60) return reject(value, "not the name of a synset");
    if (wordnet_ != nullptr && !wordnet_->has(synset)) return reject(value, "not a synset of WordNet 3.0");
    out_.accepted.synsets.push_back({category_.name, synset, source_});
  }

  std::string_view wrong_with(const std::string& text) const {
    if (kind_ == FactKind::Context) return wrong_with_context(text);
    if (kind_ == FactKind::Function) {
      const auto wrong = wrong_with_function(text);
      if (!wrong.empty()) return wrong;
      if (names_it(text, category_.display) || names_it(text, category_.plural)) return "names the object itself";
    } else if (const auto wrong = wrong_with_synonym(text); !wrong.empty()) {
      return wrong;
    }
    const auto named = known_.named.find(text);
    if (named == known_.named.end()) return "";
    return named->second.contains(category_.name) ? "already its name" : "the name of another category";
  }

  void take_phrase(const Json& value) {
    if (!value.is_string()) return reject(value, "not in the requested form");
    const auto& text = value.get_ref<const std::string&>();
    if (const auto wrong = wrong_with(text); !wrong.empty()) return reject(value, wrong);
    const AliasKind kind = kind_ == FactKind::Aliases    ? AliasKind::Synonym
                           : kind_ == FactKind::Function ? AliasKind::Function
                                                         : AliasKind::Context;
    for (const auto& a : out_.accepted.aliases) {
      if (a.category == category_.name && a.kind == kind && a.text == text) return reject(value, "a duplicate");
    }
    out_.accepted.aliases.push_back({category_.name, text, kind, source_});
  }

  void take_place(const Json& value) {
    const auto text = [&](const char* name) {
      return value.is_object() && value.contains(name) && value.at(name).is_string() ? value.at(name).get<std::string>()
                                                                                     : std::string();
    };
    const auto word = text("relation"), receptacle = text("receptacle");
    if (word.empty() || receptacle.empty() || !value.contains("likelihood") || !value.at("likelihood").is_number())
      return reject(value, "not in the requested form");
    const double likelihood = value.at("likelihood").get<double>();
    if (!std::isfinite(likelihood) || likelihood < kSmallest || likelihood > 1) return reject(value, "out of bounds");
    const auto known_relation = placement_relation_named(word);
    if (known_relation != Predicate::On && known_relation != Predicate::Inside)
      return reject(value, "an unknown relation");
    const Predicate relation = *known_relation;
    const auto at = known_.categories.find(receptacle);
    if (at == known_.categories.end()) return reject(value, "an unknown category");
    const auto affordances = known_.affordances.find(receptacle);
    if (affordances == known_.affordances.end() || !can_be_kept(category_, relation, *at->second, affordances->second))
      return reject(value, "does not fit there");
    for (const auto& p : out_.accepted.placements) {
      if (p.object == category_.name && p.relation == relation && p.receptacle == receptacle)
        return reject(value, "a duplicate");
    }
    out_.accepted.placements.push_back({category_.name, relation, receptacle, std::round(likelihood * 1000) / 1000,
                                        capacity_of(category_, relation, *at->second), source_});
  }

  std::string_view wrong_with_affordance(const std::string& name) const {
    if (std::find(affordance_names().begin(), affordance_names().end(), name) == affordance_names().end())
      return "an unknown affordance";
    const bool against_body = (name == "pickupable" && !category_.movable) ||
                              (name == "openable" && !opens(category_.archetype)) ||
                              (name == "container" && !room_of(category_, Predicate::Inside)) ||
                              (name == "receptacle" && !room_of(category_, Predicate::On));
    return against_body ? "not possible with its shape" : "";
  }

  void take_affordance(const Json& value) {
    if (!value.is_string()) return reject(value, "not in the requested form");
    const auto& name = value.get_ref<const std::string&>();
    if (const auto wrong = wrong_with_affordance(name); !wrong.empty()) return reject(value, wrong);
    for (const auto& f : out_.accepted.affordances) {
      if (f.category == category_.name && f.affordance == name) return reject(value, "a duplicate");
    }
    out_.accepted.affordances.push_back({category_.name, name, source_});
  }

  const Known& known_;
  const Category& category_;
  const Source& source_;
  const WordNet* wordnet_;
  CheckedAnswer& out_;
  FactKind kind_ = FactKind::Size;
};

}  // namespace

CheckedAnswer check_completion(std::string_view answer, const Tables& tables, const CompletionBatch& batch,
                               const Source& source, const WordNet* wordnet) {
  CheckedAnswer out;
  const auto reject_all = [&](const std::string& category, std::string_view reason) {
    out.rejected.push_back({plain_line(category, kLongestShown), "", "", std::string(reason)});
  };
  const Json json = nested_too_deep(answer) ? Json() : Json::parse(answer, nullptr, false);
  if (!json.is_object() || !json.contains("categories") || !json.at("categories").is_array()) {
    for (const auto& name : batch.categories) reject_all(name, "no list of categories in the answer");
    return out;
  }
  const Known known(tables);
  std::set<std::string> answered;
  for (const auto& entry : json.at("categories")) {
    const bool named = entry.is_object() && entry.contains("category") && entry.at("category").is_string();
    if (!named) {
      reject_all("", "an entry without a category");
      continue;
    }
    const auto name = entry.at("category").get<std::string>();
    const auto at = known.categories.find(name);
    const bool asked = std::find(batch.categories.begin(), batch.categories.end(), name) != batch.categories.end();
    if (at == known.categories.end() || !asked) {
      reject_all(name, at == known.categories.end() ? "an unknown category" : "a category that was not requested");
    } else if (!answered.insert(name).second) {
      reject_all(name, "a duplicate");
    } else {
      Entry of_category(known, *at->second, source, wordnet, out);
      for (const auto kind : batch.facts) {
        const auto value = entry.find(std::string(name_of(kind)));
        if (value != entry.end() && !value->is_null()) of_category.take(kind, *value);
      }
    }
  }
  for (const auto& name : batch.categories) {
    if (!answered.contains(name)) reject_all(name, "missing from the answer");
  }
  return out;
}

}  // namespace unietp
