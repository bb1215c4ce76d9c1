#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "akb/knowledge.h"
#include "annotator/everyday_names.h"
#include "core/shared_value.h"
#include "logic/formula.h"

namespace unietp {

/// A word of an instruction, lower case, or a punctuation mark.
struct Token {
  std::string text;
  int column = 0;  // 1-based, bytes
};
/// Words and punctuation marks in order; "half an apple" as "an half apple", "gray" as "grey".
std::vector<Token> tokens_of(std::string_view text);
/// Whether the words of `name` come in the text one after another.
bool says(const std::vector<Token>& text, std::string_view name);

/// What slices of a thing are slices of, by its name: "celery" of "celery stalk", "sourdough" of "sourdough loaf"; the
/// name itself of most.
std::string as_sliced(std::string_view name);

/// How an object named by its function is named again, after "that": "thing to drink from" for "something to drink
/// from";
/// "" for what has no singular, as "leaves for a salad".
std::string named_again(std::string_view use);

/// "where we wash our hands" of "the place where we wash our hands"; "" for what names no place so.
std::string where_of(std::string_view use);
/// The same of every such phrase behind a preposition in a text: "in the place where we wash our hands".
std::string with_plain_places(std::string text);

/// "a mug", "an apple", "an hour glass", "a utensil": by pronunciation; "half an apple".
std::string with_article(const std::string& noun);

/// What the objects of a knowledge base are called: display names, plurals, synonyms, function phrases, room types;
/// display names are those that people say every day. Making one costs milliseconds and is done once for a knowledge
/// base; a copy shares all but the phrases.
class NounTable {
 public:
  NounTable(const Knowledge& knowledge, SharedValue<EverydayNames> everyday, English english = English::Us);

  struct Name {
    std::string singular, plural;
    bool countable = true;
    bool movable = false;  // a thing that is carried about, of which people mostly say "a" at first
  };
  /// A category's or room type's display name; nullptr when the knowledge base does not know it.
  const Name* display(const std::string& category) const;
  /// Other names that people say, which mean this category and no other and do not contain its display name, in table
  /// order. A text may also have those that only a dictionary knows.
  std::vector<Name> synonyms(const std::string& category) const;
  /// What stands for things without their names: a noun phrase ("something to drink from", "a piece of cutlery", "the
  /// place where we wash our hands") or a sentence ("I want to make a salad.", "It's too dark to read.").
  struct Phrase {
    AliasKind use = AliasKind::Function;
    Domain noun;
    Predicate state = Predicate::Open;  // of a request: what it asks for
    std::string text;                   // as it is written
    std::string need;                   // of an occasion: "something to make it with"
  };
  /// What a pair or set is called where it is clear that there is one: "pants", "keys"; "" for what is none, and for
  /// what would mean something else, too.
  std::string without_set(const std::string& category) const;
  /// The phrases of one use that mean exactly these categories, in order of text.
  std::vector<std::string> phrases(const Domain& noun, AliasKind use) const;

  /// What is needed on the occasions that need exactly these, in order of their sentences.
  std::vector<std::string> needs(const Domain& noun) const;
  /// Every phrase by its text; `narrow` restricts one to the categories that a goal allows.
  const std::map<std::string, Phrase, std::less<>>& phrases() const { return phrases_; }
  void narrow(const std::string& phrase, const Domain& noun);

  /// The English that its display names are of.
  English english() const { return fixed_->english; }
  /// What it was made with.
  const SharedValue<EverydayNames>& everyday() const { return fixed_->everyday; }
  bool is_room_type(const std::string& category) const;  // by the knowledge base, as the two below
  bool is_color(const std::string& word) const;
  bool is_material(const std::string& word) const;
  /// Whether some category is called exactly this.
  bool is_name(const std::string& text) const;

  /// The possible meanings of a noun at some position of a text.
  struct Reading {
    std::size_t length = 0;     // tokens; 0 when there is no noun
    std::vector<Domain> nouns;  // more than one: the name is ambiguous
    bool singular = false, plural = false, mass = false;
  };
  /// The longest noun that starts here: "slice of coffee cake" before "slice". Display names win over synonyms.
  /// Where a category is itself called "slice of bread", the name means one of these first, then what slicing makes,
  /// which "freshly cut slice of bread" always means. "Glass" before another noun is what that is made of.
  Reading noun_at(const std::vector<Token>& tokens, std::size_t at) const;
  /// The singular name of a type of room.
  Reading room_at(const std::vector<Token>& tokens, std::size_t at) const;
  /// The phrase that starts here, unless a name goes on behind its article: "a light switch" is no light.
  Reading function_at(const std::vector<Token>& tokens, std::size_t at) const;
  /// The same for "where we wash our hands", of "the place where we wash our hands".
  Reading where_at(const std::vector<Token>& tokens, std::size_t at) const;
  /// The same for a function phrase that is named again, after "that".
  Reading function_again_at(const std::vector<Token>& tokens, std::size_t at) const;
  /// The occasion or request that starts here, with its number of tokens; nullptr when there is none.
  std::pair<const Phrase*, std::size_t> sentence_at(const std::vector<Token>& tokens, std::size_t at) const;

 private:
  struct Entry {
    std::vector<std::string> words;
    Domain noun;
    bool singular = false, plural = false, mass = false;
    int rank = 0;  // display names before synonyms
  };
  using Index = std::unordered_map<std::string, std::vector<Entry>>;  // by first word, longest first
  struct Names;
  static void add_category(Names& made, const Category& category, std::set<std::string, std::less<>>& taken);
  static void add_synonym(Names& made, const Alias& alias, const Category& category);
  static void add_room(Names& made, const std::string& room);
  static void add_general_nouns(Names& made);
  void add_phrase(const Alias& alias);
  void index_phrase(Names& made, const std::string& text, const Phrase& phrase);
  static void add(Index& index, const std::string& text, const Domain& noun, bool singular, bool plural, bool mass,
                  int rank);
  static void narrow(Index& index, std::string_view words, const Domain& noun);
  static Reading longest(const Index& index, const std::vector<Token>& tokens, std::size_t at);

  struct Names {  // immutable
    English english = English::Us;
    SharedValue<EverydayNames> everyday;
    std::map<std::string, Name, std::less<>> names;
    std::map<std::string, std::vector<Name>, std::less<>> synonyms;
    std::vector<std::string> room_types, colors, materials;  // sorted
    std::map<std::string, std::vector<std::pair<std::vector<std::string>, std::string>>, std::less<>> sentences;
    Index nouns, rooms;
  };
  std::shared_ptr<const Names> fixed_;
  std::map<std::string, Phrase, std::less<>> phrases_;  // by text, lower case
  Index in_full_, again_, where_;  // of noun phrases: in full, when named again, and of places from "where" on
};

}  // namespace unietp
