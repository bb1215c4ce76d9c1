#include "annotator/another_meaning.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <span>
#include <string_view>
#include <vector>

namespace unietp {
namespace {

using Op = Formula::Op;

bool contains(std::span<const std::string> words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

std::string joined(std::span<const Token> words) {
  std::string text;
  for (const Token& word : words) text += (text.empty() ? "" : " ") + word.text;
  return text;
}

/// "Half pizza" and "slice of bread", of "pizza" and "bread".
bool is_part(std::string_view part, std::string_view whole) {
  constexpr std::array<std::string_view, 3> kParts{"half ", "slice of ", "piece of "};
  return std::any_of(kParts.begin(), kParts.end(), [&](std::string_view before) {
    return part.starts_with(before) && part.substr(before.size()) == whole;
  });
}

/// "Eyeglasses" of "pair of eyeglasses".
std::string_view head(std::string_view name) {
  constexpr std::string_view kPair = "pair of ";
  return name.starts_with(kPair) ? name.substr(kPair.size()) : name;
}

class Listener {
 public:
  Listener(const std::string& text, const Formula& goal, const Scene& home, const Knowledge& knowledge,
           const NounTable& nouns)
      : text_(text),
        words_(tokens_of(text)),
        goal_(goal),
        home_(home),
        knowledge_(knowledge),
        nouns_(nouns),
        own_(categories_of(goal)) {
    std::map<std::string_view, std::string_view> type_of;
    for (const Room& room : home.rooms) type_of.emplace(room.id, room.type);
    for (const Edge& edge : home.edges)
      if (edge.relation == Predicate::InRoom) room_of_[edge.from] = type_of[edge.to];
    for (const Node& node : home.nodes)
      if (!contains(own_, node.category)) others_.insert(node.category);
    for (std::size_t i = 0; i < words_.size();) {
      const std::size_t length = nouns.noun_at(words_, i).length;
      if (length > 0) said_.insert(joined(std::span(words_).subspan(i, length)));
      i += std::max<std::size_t>(length, 1);
    }
  }

  bool takes_another() const {
    return std::any_of(own_.begin(), own_.end(), [&](const std::string& own) { return hears_other(own); }) ||
           hears_other_use() || sees_other_beside_the_room(goal_);
  }

 private:
  bool says_name(const NounTable::Name& name) const { return says(words_, name.singular) || says(words_, name.plural); }

  /// Whether another thing of the home has such a name, or looks like what has it.
  bool hears_other(const std::string& own) const {
    const NounTable::Name* name = nouns_.display(own);
    const Category* known = knowledge_.find(own);
    if (name == nullptr || known == nullptr) return false;
    if (hears_other_synonym(own) || wishes_for_part(known->display)) return true;
    if (!says_name(*name)) return false;
    const std::string_view place = place_in(name->singular);
    if (!place.empty() && says_twice(*name, place)) return true;
    if (!known->movable && !place.empty() && !stands_in(own, known->rooms) && !stands_in_any_room(own)) return true;
    const auto alike = nouns_.everyday()->look_alikes(known->display);
    if (says_one_of(alike, own)) return true;
    return std::any_of(others_.begin(), others_.end(), [&](const std::string& there) {
      const Category* other = knowledge_.find(there);
      return other != nullptr && (is_among(alike, *other) || is_called(there, *other, name->singular)) &&
             (place.empty() || !is_room(place) || stands_in(there, std::array{std::string(place)}));
    });
  }

  /// "The pair of glasses and the pair of eyeglasses": which is which?
  bool says_one_of(std::span<const std::string> alike, const std::string& own) const {
    return std::any_of(own_.begin(), own_.end(), [&](const std::string& another) {
      const Category* known = knowledge_.find(another);
      const NounTable::Name* name = nouns_.display(another);
      return another != own && known != nullptr && name != nullptr && contains(alike, known->display) &&
             (said_.contains(joined(tokens_of(name->singular))) || said_.contains(joined(tokens_of(name->plural))));
    });
  }

  /// "The counter", of the kitchen counter, where there is a bathroom counter.
  bool hears_other_synonym(const std::string& own) const {
    const auto synonyms = nouns_.synonyms(own);
    return std::any_of(synonyms.begin(), synonyms.end(), [&](const NounTable::Name& name) {
      return (said_.contains(joined(tokens_of(name.singular))) || said_.contains(joined(tokens_of(name.plural)))) &&
             has_one_of(nouns_.everyday()->look_alikes(name.singular));
    });
  }

  /// "I'd like a warm piece of bread.", where there is a loaf to cut one from.
  bool wishes_for_part(std::string_view own) const {
    constexpr std::array<std::string_view, 3> kWishes{"I'd like ", "I could use ", "I want "};
    const bool wishes = std::any_of(kWishes.begin(), kWishes.end(),
                                    [&](std::string_view wish) { return text_.find(wish) != std::string::npos; });
    return wishes && std::any_of(others_.begin(), others_.end(), [&](const std::string& there) {
             const Category* other = knowledge_.find(there);
             return other != nullptr && is_part(own, other->display);
           });
  }

  bool has_one_of(std::span<const std::string> alike) const {
    return std::any_of(others_.begin(), others_.end(), [&](const std::string& there) {
      const Category* other = knowledge_.find(there);
      return other != nullptr && is_among(alike, *other);
    });
  }

  /// By name or by kind.
  static bool is_among(std::span<const std::string> alike, const Category& other) {
    return contains(alike, other.display) ||
           std::any_of(other.kinds.begin(), other.kinds.end(),
                       [&](const std::string& kind) { return contains(alike, "kind " + kind); });
  }

  /// "The kitchen cabinets in the kitchen": as if there were others.
  bool says_twice(const NounTable::Name& name, std::string_view place) const {
    const std::string room = " in the " + std::string(place);
    return text_.find(name.singular + room) != std::string::npos || text_.find(name.plural + room) != std::string::npos;
  }

  /// The room or use that a name of furniture starts with: "bathroom" of "bathroom sink"; or "".
  static std::string_view place_in(std::string_view name) {
    constexpr std::array<std::string_view, 5> kPlaces{"dining", "kitchen", "bathroom", "bedside", "office"};
    const std::string_view word = name.substr(0, name.find(' '));
    return std::find(kPlaces.begin(), kPlaces.end(), word) == kPlaces.end() ? std::string_view() : word;
  }

  bool is_room(std::string_view type) const {
    return std::any_of(home_.rooms.begin(), home_.rooms.end(), [&](const Room& room) { return room.type == type; });
  }

  bool stands_in(const std::string& category, std::span<const std::string> room_types) const {
    return std::any_of(home_.nodes.begin(), home_.nodes.end(), [&](const Node& node) {
      return node.category == category && contains(room_types, room_of(node.id));
    });
  }

  /// Whether one stands in a room of a type that the knowledge has nothing in: an imported home may not tell what its
  /// rooms are for.
  bool stands_in_any_room(const std::string& category) const {
    const auto& all = knowledge_.categories();
    return std::any_of(home_.nodes.begin(), home_.nodes.end(), [&](const Node& node) {
      return node.category == category && std::none_of(all.begin(), all.end(), [&](const Category& known) {
               return std::find(known.rooms.begin(), known.rooms.end(), room_of(node.id)) != known.rooms.end();
             });
    });
  }

  bool is_called(const std::string& category, const Category& known, std::string_view name) const {
    if (head(known.display) == head(name)) return true;
    const auto synonyms = nouns_.synonyms(category);
    return std::any_of(synonyms.begin(), synonyms.end(),
                       [&](const NounTable::Name& synonym) { return head(synonym.singular) == head(name); });
  }

  /// Of what is named by its use: whether something else there would do as well. Of an occasion, the table may have a
  /// row for what is needed and another for the sentence.
  bool hears_other_use() const {
    return std::any_of(nouns_.phrases().begin(), nouns_.phrases().end(), [&](const auto& entry) {
      const NounTable::Phrase& phrase = entry.second;
      if (!says_text(phrase.need.empty() ? phrase.text : phrase.need)) return false;
      if (has_one_of(nouns_.everyday()->look_alikes(phrase.need.empty() ? phrase.text : phrase.need))) return true;
      if (!says_text(phrase.text)) return false;
      return has_one_of(nouns_.everyday()->look_alikes(phrase.text)) || has_other_that_is_meant(phrase);
    });
  }

  bool says_text(const std::string& words) const { return text_.find(words) != std::string::npos; }

  /// Whether the home has something that the phrase means and the goal does not accept, since it cannot be done with
  /// it: something to heat water in is a kettle, too, where only the pot can be washed.
  bool has_other_that_is_meant(const NounTable::Phrase& phrase) const {
    std::string text = phrase.need.empty() ? phrase.text : phrase.need + ": " + phrase.text;
    if (phrase.use == AliasKind::Request) text = std::string(info(phrase.state).name) + " " + text;
    const auto is_meant = [&](const std::string& category) {
      const auto aliases = knowledge_.aliases_of(category, phrase.use);
      return std::any_of(aliases.begin(), aliases.end(), [&](const Alias* alias) { return alias->text == text; });
    };
    return std::any_of(own_.begin(), own_.end(), is_meant) && std::any_of(others_.begin(), others_.end(), is_meant);
  }

  /// "The bedroom side table", where the next one stands on the other side of the bedroom's door.
  bool sees_other_beside_the_room(const Formula& formula) const {
    for (const Formula& where : formula.domain.where) {
      const bool of_room = where.op == Op::Exists && where.domain.members.size() == 1 &&
                           where.children[0].op == Op::Atom && where.children[0].predicate == Predicate::InRoom;
      if (of_room && formula.domain.members.size() == 1 &&
          stands_beside(formula.domain.members[0].category, where.domain.members[0].category))
        return true;
      if (sees_other_beside_the_room(where)) return true;
    }
    return std::any_of(formula.children.begin(), formula.children.end(),
                       [&](const Formula& child) { return sees_other_beside_the_room(child); });
  }

  bool stands_beside(const std::string& category, std::string_view room) const {
    const Category* known = knowledge_.find(category);
    if (known == nullptr || known->movable) return false;
    std::set<std::string_view> outside;
    for (const Node& node : home_.nodes)
      if (node.category == category && room_of(node.id) != room) outside.insert(node.id);
    return std::any_of(home_.edges.begin(), home_.edges.end(), [&](const Edge& edge) {
      return edge.relation == Predicate::NextTo && outside.contains(edge.from) && room_of(edge.to) == room;
    });
  }

  std::string_view room_of(std::string_view node) const {
    const auto found = room_of_.find(node);
    return found == room_of_.end() ? std::string_view() : found->second;
  }

  const std::string& text_;
  std::vector<Token> words_;
  const Formula& goal_;
  const Scene& home_;
  const Knowledge& knowledge_;
  const NounTable& nouns_;
  std::vector<std::string> own_;                          // categories of the goal
  std::set<std::string> others_;                          // and of what else is there
  std::set<std::string> said_;                            // names that the text says, in full
  std::map<std::string_view, std::string_view> room_of_;  // the type of room that a node is in
};

}  // namespace

bool may_mean_another(const std::string& text, const Formula& goal, const Scene& home, const Knowledge& knowledge,
                      const NounTable& nouns) {
  return Listener(text, goal, home, knowledge, nouns).takes_another();
}

}  // namespace unietp
