#include "annotator/noun_table.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "annotator/everyday_names.h"
#include "annotator/plural.h"
#include "core/text.h"

namespace unietp {
namespace {

bool is_word_char(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return std::isalnum(byte) || c == '\'' || c == '-' || c == '_' || c == '&' || c == '/' || byte >= 0x80;
}

/// "LivingRoom", "living_room" -> "living room"
std::string spaced(const std::string& name) {
  std::string text;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const bool upper = std::isupper(static_cast<unsigned char>(name[i]));
    if (upper && i > 0 && std::islower(static_cast<unsigned char>(name[i - 1]))) text += ' ';
    text += name[i] == '_' ? ' ' : name[i];
  }
  return lower(text);
}

constexpr std::string_view kHalf = "half ";
/// What people leave out where there is one: "the glasses", "the keys".
constexpr std::array<std::string_view, 4> kSets{"pair of ", "set of ", "bunch of ", "deck of "};
constexpr double kSaid = 0.8;  // the confidence of names that people say; a dictionary's are only read

/// "keys" of "set of keys"; "" of a name that has no such head.
std::string_view things_of_set(std::string_view name) {
  for (const std::string_view set : kSets)
    if (name.starts_with(set)) return name.substr(set.size());
  return "";
}

/// Whether a name is of one thing, as "glasses" is not.
bool is_one(std::string_view name) {
  for (const std::string_view link : {" of ", " with ", " for ", " in "}) name = name.substr(0, name.find(link));
  return !name.ends_with('s') || name.ends_with("ss") || name.ends_with("us");
}

constexpr std::array kUsualRooms{"Bathroom", "Bedroom", "Kitchen", "LivingRoom"};  // for a base that names none

}  // namespace

std::vector<Token> tokens_of(std::string_view text) {
  std::vector<Token> tokens;
  tokens.reserve(text.size() / 4 + 1);
  for (std::size_t i = 0; i < text.size();) {
    if (std::isspace(static_cast<unsigned char>(text[i]))) {
      ++i;
      continue;
    }
    std::size_t end = i + 1;
    if (is_word_char(text[i]))
      while (end < text.size() && is_word_char(text[end])) ++end;
    tokens.push_back({lower(text.substr(i, end - i)), static_cast<int>(i) + 1});
    if (tokens.back().text == "gray") tokens.back().text = "grey";
    i = end;
  }
  for (std::size_t i = 0; i + 1 < tokens.size(); ++i)  // "half an apple" is a half apple
    if (tokens[i].text == "half" && (tokens[i + 1].text == "a" || tokens[i + 1].text == "an"))
      std::swap(tokens[i], tokens[i + 1]);
  const auto comes = [&](std::size_t at, std::initializer_list<std::string_view> words) {
    return at + words.size() <= tokens.size() &&
           std::equal(words.begin(), words.end(), tokens.begin() + static_cast<std::ptrdiff_t>(at),
                      [](std::string_view word, const Token& token) { return token.text == word; });
  };
  for (std::size_t i = 0; i < tokens.size(); ++i) {  // "the dining room table" is the dining table in the dining room
    if (!comes(i, {"dining", "room", "table"})) continue;
    tokens[i + 1].text = "table";
    tokens[i + 2].text = "in";
    const int column = tokens[i + 2].column;
    tokens.insert(tokens.begin() + static_cast<std::ptrdiff_t>(i) + 3,
                  {Token{"the", column}, Token{"dining", column}, Token{"room", column}});
  }
  return tokens;
}

bool says(const std::vector<Token>& text, std::string_view name) {
  const std::vector<Token> words = tokens_of(name);
  const auto same = [](const Token& a, const Token& b) { return a.text == b.text; };
  return std::search(text.begin(), text.end(), words.begin(), words.end(), same) != text.end();
}

std::string with_article(const std::string& noun) {
  const std::string word = lower(noun);
  const auto starts = [&](std::string_view head) { return word.starts_with(head); };
  bool vowel = starts_with_vowel_letter(word);
  for (const char* you : {"uni", "usb", "use", "usu", "ute", "uku", "ura", "euro", "ewe", "one", "once"})
    if (starts(you)) vowel = false;  // spoken "you…", "w…"
  for (const char* like_un : {"unin", "unim"})
    if (starts(like_un)) vowel = true;
  for (const char* silent :
       {"hour", "heir", "honest", "herb", "8", "11", "18", "lcd", "mp3", "x-ray", "f-", "l-", "s-"})
    if (starts(silent)) vowel = true;
  if (starts("half ")) return "half " + with_article(noun.substr(5));
  return (vowel ? "an " : "a ") + noun;
}

std::string as_sliced(std::string_view name) {
  constexpr std::string_view kStalk = "stalk of ";
  if (name.starts_with(kStalk)) return std::string(name.substr(kStalk.size()));
  for (const std::string_view part : {" stalk", " bulb", " clove", " spear", " loaf"})
    if (name.ends_with(part)) return std::string(name.substr(0, name.size() - part.size()));
  return std::string(name);
}

std::string named_again(std::string_view use) {
  for (const std::string_view article : {"a ", "an ", "the ", "any ", "some "})
    if (use.starts_with(article)) return std::string(use.substr(article.size()));
  for (const std::string_view thing : {"something ", "anything "})
    if (use.starts_with(thing)) return "thing " + std::string(use.substr(thing.size()));
  return "";
}

constexpr std::array<std::string_view, 2> kPlaces{"the place where ", "the spot where "};

std::string where_of(std::string_view use) {
  for (const std::string_view place : kPlaces)
    if (use.starts_with(place)) return std::string(use.substr(place.size() - std::string_view("where ").size()));
  return "";
}

std::string with_plain_places(std::string text) {
  for (const std::string_view place : kPlaces)
    for (const std::string_view at : {" in ", " into ", " on ", " onto ", " to "})
      text = replace_all(text, std::string(at) + std::string(place), " where ");
  return text;
}

NounTable::NounTable(const Knowledge& knowledge, SharedValue<EverydayNames> everyday, English english) {
  Names made;
  made.english = english;
  made.everyday = std::move(everyday);
  std::set<std::string> rooms, colors, materials;
  std::set<std::string, std::less<>> taken;
  for (const Category& category : knowledge.categories()) taken.insert(category.display);
  for (const Category& category : knowledge.categories()) {
    add_category(made, category, taken);
    rooms.insert(category.rooms.begin(), category.rooms.end());
    colors.insert(category.colors.begin(), category.colors.end());
    materials.insert(category.materials.begin(), category.materials.end());
  }
  for (const Alias& alias : knowledge.aliases()) {
    const Category* category = knowledge.find(alias.category);
    if (category == nullptr) continue;
    if (alias.kind == AliasKind::Synonym) {
      add_synonym(made, alias, *category);
    } else {
      add_phrase(alias);
    }
  }
  for (const auto& [text, phrase] : phrases_) index_phrase(made, text, phrase);
  if (rooms.empty()) rooms.insert(kUsualRooms.begin(), kUsualRooms.end());
  for (const std::string& room : rooms) add_room(made, room);
  add_general_nouns(made);
  made.colors.assign(colors.begin(), colors.end());
  made.materials.assign(materials.begin(), materials.end());
  fixed_ = std::make_shared<const Names>(std::move(made));
}

/// Its display name, what people call it every day in both kinds of English, and the forms of these. `taken`: the names
/// that are spoken for.
void NounTable::add_category(Names& made, const Category& category, std::set<std::string, std::less<>>& taken) {
  made.names[category.name] = {category.display, category.plural, category.countable, category.movable};
  for (const English one : {made.english, made.english == English::Us ? English::Gb : English::Us}) {
    const std::string_view usual = made.everyday->of(category.display, one);
    const bool again = one != made.english && usual == made.everyday->of(category.display, made.english);
    if (usual.empty() || usual == category.display || again || !taken.emplace(usual).second) continue;
    const bool countable =  // "roll of toilet paper", "toilet roll"
        category.countable || usual.find(" of ") != usual.npos || usual.ends_with(" roll");
    const Name name{std::string(usual), countable ? plural_of(usual) : std::string(usual), countable, category.movable};
    if (one == made.english) made.names[category.name] = name;
    const int rank = one == made.english ? 0 : 1;
    add(made.nouns, name.singular, of_category(category.name), name.countable, false, !name.countable, rank);
    if (name.countable) add(made.nouns, name.plural, of_category(category.name), false, true, false, rank);
  }
  const Domain noun = of_category(category.name);
  add(made.nouns, category.display, noun, category.countable, false, !category.countable, 0);
  const std::string& said = made.names[category.name].singular;
  if ((said == "stove" || said == "cooker") && !taken.contains("oven"))
    for (const auto& [text, plural] : {std::pair{"oven", false}, std::pair{"ovens", true}})
      add(made.nouns, text, noun, !plural, plural, false, 1);
  if (const std::string things(things_of_set(said)); !things.empty())
    add(made.nouns, things, noun, false, false, true, 2);
  if (const std::string plant = as_sliced(said); plant != said && !taken.contains(plant) && !said.ends_with(" loaf"))
    add(made.nouns, plant, noun, false, false, true, 2);
  if (said.starts_with(kHalf)) {
    if (said.find(" of ") == std::string::npos)
      made.names[category.name].plural = said.substr(kHalf.size()) + " halves";
    add(made.nouns, said.substr(kHalf.size()) + " half", noun, true, false, false, 0);
    add(made.nouns, made.names[category.name].plural, noun, false, true, false, 0);
  }
  if (category.countable) add(made.nouns, category.plural, noun, false, true, false, 0);
}

void NounTable::add_synonym(Names& made, const Alias& alias, const Category& category) {
  if (alias.text == things_of_set(made.names[alias.category].singular)) return;  // read as the set already
  const Name name{alias.text, category.countable ? plural_of(alias.text) : alias.text, category.countable,
                  category.movable};
  if (alias.source.confidence >= kSaid && made.everyday->is_said(alias.text, made.english))
    made.synonyms[alias.category].push_back(name);
  const Domain noun = of_category(alias.category);
  add(made.nouns, name.singular, noun, name.countable, false, !name.countable, 1);
  if (name.countable) add(made.nouns, name.plural, noun, false, true, false, 1);
}

/// Makes a phrase that add_phrase has collected findable by its words: a sentence, or a noun phrase in its three forms.
void NounTable::index_phrase(Names& made, const std::string& text, const Phrase& phrase) {
  if (phrase.use == AliasKind::Occasion || phrase.use == AliasKind::Request) {
    std::vector<std::string> words;
    for (const Token& token : tokens_of(text)) words.push_back(token.text);
    made.sentences[words.front()].emplace_back(words, text);
    return;
  }
  add(in_full_, text, phrase.noun, true, false, false, 0);
  add(again_, named_again(text), phrase.noun, true, false, false, 0);
  add(where_, where_of(text), phrase.noun, true, false, false, 0);
}

void NounTable::add_room(Names& made, const std::string& room) {
  if (made.names.contains(room)) return;
  const std::string_view usual = made.everyday->of(spaced(room), made.english);
  for (const std::string& name : {spaced(room), std::string(usual)}) {
    if (name.empty()) continue;
    made.names[room] = {name, plural_of(name), true, false};
    add(made.nouns, name, of_category(room), true, false, false, 0);
    add(made.rooms, name, of_category(room), true, false, false, 0);
    add(made.nouns, plural_of(name), of_category(room), false, true, false, 0);
  }
  made.room_types.push_back(room);
}

/// "object", "room" and "agent", which the names of categories and room types precede.
void NounTable::add_general_nouns(Names& made) {
  for (const auto& [kind, noun] : {std::pair{Domain::Kind::Object, "object"}, std::pair{Domain::Kind::Room, "room"},
                                   std::pair{Domain::Kind::Agent, "agent"}}) {
    Domain domain;
    domain.kind = kind;
    add(made.nouns, noun, domain, true, false, false, 2);
    add(made.nouns, std::string(noun) + "s", domain, false, true, false, 2);
  }
}

/// Adds the category of an alias to what its phrase means. A phrase is of one use: the first.
void NounTable::add_phrase(const Alias& alias) {
  if (alias.kind == AliasKind::Context) return;
  std::string_view text = alias.text;
  Predicate state = Predicate::Open;
  if (alias.kind == AliasKind::Request) {
    state = predicate_named(text.substr(0, text.find(' '))).value_or(state);
    text.remove_prefix(std::min(text.find(' ') + 1, text.size()));
  }
  std::string need;
  if (alias.kind == AliasKind::Occasion) {  // "something to stir it with: I want to stir the soup."
    const auto end = text.find(": ");
    need = end == text.npos ? "what I need" : std::string(text.substr(0, end));
    if (end != text.npos) text.remove_prefix(end + 2);
  }
  const auto [at, is_new] = phrases_.try_emplace(lower(text), Phrase{alias.kind, {}, state, std::string(text), need});
  auto& members = at->second.noun.members;
  const Domain::Member member{alias.category, false};
  if (at->second.use != alias.kind || at->second.state != state) return;
  const auto place = std::lower_bound(members.begin(), members.end(), member,
                                      [](const auto& a, const auto& b) { return a.category < b.category; });
  if (place == members.end() || *place != member) members.insert(place, member);
}

void NounTable::add(Index& index, const std::string& text, const Domain& noun, bool singular, bool plural, bool mass,
                    int rank) {
  Entry entry{{}, noun, singular, plural, mass, rank};
  for (const Token& token : tokens_of(text)) entry.words.push_back(token.text);
  if (entry.words.empty()) return;
  std::vector<Entry>& bucket = index[entry.words.front()];
  const auto longer = [](const Entry& a, const Entry& b) { return a.words.size() > b.words.size(); };
  bucket.insert(std::upper_bound(bucket.begin(), bucket.end(), entry, longer), entry);
}

const NounTable::Name* NounTable::display(const std::string& category) const {
  const auto found = fixed_->names.find(category);
  return found == fixed_->names.end() ? nullptr : &found->second;
}

std::string NounTable::without_set(const std::string& category) const {
  const Name* name = display(category);
  std::string bare(name == nullptr ? "" : things_of_set(name->singular));
  if (bare.empty()) return "";
  const auto words = tokens_of(bare);
  const Reading read = longest(fixed_->nouns, words, 0);
  const bool clear = read.length == words.size() && read.nouns.size() == 1 && read.nouns[0] == of_category(category);
  return clear ? bare : "";
}

std::vector<NounTable::Name> NounTable::synonyms(const std::string& category) const {
  const auto found = fixed_->synonyms.find(category);
  if (found == fixed_->synonyms.end()) return {};
  const std::string& own = fixed_->names.find(category)->second.singular;
  std::vector<Name> usable;
  for (const Name& name : found->second) {
    const std::vector<Token> tokens = tokens_of(name.singular);
    const Reading reading = longest(fixed_->nouns, tokens, 0);
    const bool clear = reading.nouns.size() == 1 && reading.nouns.front() == of_category(category);
    if (clear && reading.length == tokens.size() && !says(tokens, own) && (!name.countable || is_one(name.singular)))
      usable.push_back(name);
  }
  return usable;
}

std::vector<std::string> NounTable::phrases(const Domain& noun, AliasKind use) const {
  Domain wanted = noun;
  wanted.where.clear();
  std::sort(wanted.members.begin(), wanted.members.end(),
            [](const auto& a, const auto& b) { return a.category < b.category; });
  std::vector<std::string> texts;
  for (const auto& [text, phrase] : phrases_)
    if (phrase.use == use && phrase.noun == wanted) texts.push_back(phrase.text);
  return texts;
}

std::vector<std::string> NounTable::needs(const Domain& noun) const {
  std::vector<std::string> found;
  for (const std::string& sentence : phrases(noun, AliasKind::Occasion))
    found.push_back(phrases_.find(lower(sentence))->second.need);
  return found;
}

void NounTable::narrow(const std::string& phrase, const Domain& noun) {
  phrases_[lower(phrase)].noun = noun;
  narrow(in_full_, phrase, noun);
  narrow(again_, named_again(phrase), noun);
  narrow(where_, where_of(phrase), noun);
}

void NounTable::narrow(Index& index, std::string_view words, const Domain& noun) {
  const std::vector<Token> tokens = tokens_of(words);
  if (tokens.empty()) return;
  for (Entry& entry : index[tokens.front().text]) {
    const bool same = std::equal(tokens.begin(), tokens.end(), entry.words.begin(), entry.words.end(),
                                 [](const Token& token, const std::string& word) { return token.text == word; });
    if (same) entry.noun = noun;
  }
}

bool NounTable::is_room_type(const std::string& category) const {
  return std::binary_search(fixed_->room_types.begin(), fixed_->room_types.end(), category);
}

bool NounTable::is_color(const std::string& word) const {
  return std::binary_search(fixed_->colors.begin(), fixed_->colors.end(), word);
}

bool NounTable::is_material(const std::string& word) const {
  return std::binary_search(fixed_->materials.begin(), fixed_->materials.end(), word);
}

NounTable::Reading NounTable::longest(const Index& index, const std::vector<Token>& tokens, std::size_t at) {
  Reading reading;
  if (at >= tokens.size()) return reading;
  const auto bucket = index.find(tokens[at].text);
  if (bucket == index.end()) return reading;
  int rank = 0;
  for (const Entry& entry : bucket->second) {
    const std::size_t length = entry.words.size();
    if (length < reading.length) break;
    if (at + length > tokens.size()) continue;
    bool same = true;
    for (std::size_t i = 0; i < length && same; ++i) same = tokens[at + i].text == entry.words[i];
    if (!same || (reading.length > 0 && entry.rank > rank)) continue;
    if (reading.length == 0 || entry.rank < rank) reading = {length, {}, false, false, false}, rank = entry.rank;
    if (std::find(reading.nouns.begin(), reading.nouns.end(), entry.noun) == reading.nouns.end())
      reading.nouns.push_back(entry.noun);
    reading.singular |= entry.singular;
    reading.plural |= entry.plural;
    reading.mass |= entry.mass;
  }
  return reading;
}

NounTable::Reading NounTable::noun_at(const std::vector<Token>& tokens, std::size_t at) const {
  Reading plain = longest(fixed_->nouns, tokens, at);
  const auto word = [&](std::size_t ahead) -> std::string_view {
    return at + ahead < tokens.size() ? std::string_view(tokens[at + ahead].text) : "";
  };
  const bool quality = plain.length == 1 && (is_color(tokens[at].text) || is_material(tokens[at].text));
  if (quality && noun_at(tokens, at + 1).length > 0) return {};
  const std::size_t fresh = word(0) == "freshly" && word(1) == "cut" ? 2 : 0;
  const std::string_view head = word(fresh);
  const bool piece = head == "piece" || head == "pieces";
  const bool slice = head == "slice" || head == "slices" || (piece && word(fresh + 2) == "lettuce");
  if ((!slice && (fresh > 0 || !piece)) || word(fresh + 1) != "of") return plain;
  Reading of = longest(fixed_->nouns, tokens, at + fresh + 2);
  of.length += fresh + 2;
  if (slice)
    for (Domain& noun : of.nouns)
      for (Domain::Member& member : noun.members) member.slice = true;
  const bool usable = !of.nouns.empty() && !of.plural && (slice || of.mass);
  if (usable && slice && of.length == plain.length && plain.nouns.size() == 1)
    plain.nouns.push_back(of.nouns.front());  // one that is still to be cut, where none is cut yet
  if (!usable || of.length <= plain.length) return plain;
  of.plural = head.ends_with('s');
  of.singular = !of.plural;
  of.mass = false;
  return of;
}

NounTable::Reading NounTable::room_at(const std::vector<Token>& tokens, std::size_t at) const {
  return longest(fixed_->rooms, tokens, at);
}

bool NounTable::is_name(const std::string& text) const {
  const std::vector<Token> tokens = tokens_of(text);
  return longest(fixed_->nouns, tokens, 0).length == tokens.size();
}

NounTable::Reading NounTable::function_at(const std::vector<Token>& tokens, std::size_t at) const {
  Reading phrase = longest(in_full_, tokens, at);
  if (phrase.length == 0) return phrase;
  const std::string& article = tokens[at].text;
  const bool named = article == "a" || article == "an" || article == "the" || article == "some";
  return named && noun_at(tokens, at + 1).length + 1 > phrase.length ? Reading() : phrase;
}

NounTable::Reading NounTable::function_again_at(const std::vector<Token>& tokens, std::size_t at) const {
  return longest(again_, tokens, at);
}

NounTable::Reading NounTable::where_at(const std::vector<Token>& tokens, std::size_t at) const {
  return longest(where_, tokens, at);
}

std::pair<const NounTable::Phrase*, std::size_t> NounTable::sentence_at(const std::vector<Token>& tokens,
                                                                        std::size_t at) const {
  if (at >= tokens.size()) return {nullptr, 0};
  const auto bucket = fixed_->sentences.find(tokens[at].text);
  if (bucket == fixed_->sentences.end()) return {nullptr, 0};
  for (const auto& [words, text] : bucket->second) {
    if (at + words.size() > tokens.size()) continue;
    const bool same = std::equal(words.begin(), words.end(), tokens.begin() + static_cast<std::ptrdiff_t>(at),
                                 [](const std::string& word, const Token& token) { return word == token.text; });
    if (same) return {&phrases_.find(text)->second, words.size()};
  }
  return {nullptr, 0};
}

}  // namespace unietp
