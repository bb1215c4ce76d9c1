#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>

#include "annotator/clause.h"
#include "annotator/noun_table.h"
#include "annotator/plan.h"
#include "core/rng.h"
#include "generator/style.h"

namespace unietp {

/// A noun phrase in words, and whether its verb is plural.
struct Words {
  std::string text;
  bool plural = false;
};

/// How a plan is worded.
struct Wording {
  Style style = Style::Direct;
  bool everyday = true;                      // as people ask for things; false: a wide choice of frames and statements
  std::span<const std::string> alone = {};   // categories and room types of which the home has one, sorted: "the sink"
  std::span<const std::string> there = {};   // those of which it has any, sorted; empty where the home is not known
  std::span<const std::string> opened = {};  // categories in which something is to be, or that are opened or closed
  std::span<const std::string> unique = {};  // variables that only one thing can stand for, sorted
  double pronouns = 1;                       // share of things that are "it" where that is clear
};

/// The context of a noun phrase that limits its determiner.
struct Place {
  bool beside_every = false;  // "put every mug on …": a bare "a table" would have two readings
  bool beside_none = false;   // "no mug is on …": nothing new can be named
  bool inside_description = false;
  bool unique = false;      // the home has one only: "nearest to the sink"
  bool near = false;        // of a description: what it is next to
  bool of_every = false;    // of a description: it is of every such thing
  bool denied = false;      // of a description: what it does not fit, "that is not in any sink"
  bool wanted = false;      // some such thing, not one that is there: "someone wants a hot potato"
  bool bare = false;        // no place follows, so a place can describe the noun: "open the drawer in the kitchen"
  bool bare_room = false;   // only a room can: "on the table in the kitchen"
  bool together = false;    // "all the mugs" rather than "every mug"
  bool chosen = false;      // "choose a kitchen": there may be several
  bool outcome = false;     // of what will be so at the end: what describes it is so now
  bool beside_the = false;  // in a list with what there is one of
  bool sought = false;      // of what is fetched: "something to drink from"
  bool moved = false;       // what is put somewhere: "it" is what the last command was about
  bool exact = false;  // within a proposition: what is bound has one name, "some mug … the mug", and is never "it"
};

/// Names the objects of one text from left to right, and records which were named before and how.
/// `nullopt` from any member: this wording is impossible; the caller tries another one.
class Naming {
 public:
  Naming(const Plan& plan, const NounTable& lexicon, const Wording& wording, Rng& rng)
      : plan_(plan), lexicon_(lexicon), style_(wording.style), wording_(wording), rng_(rng) {}

  bool everyday() const { return wording_.everyday; }  // whether it writes as people ask for things
  /// Whether "no …" is to be said as such; whether the text is to speak of what is to stay as it is.
  bool keeps_no() const { return style_ == Style::Negation; }
  bool distracts() const { return style_ == Style::Distractor; }
  /// What the command so far was about: the "it" of "…, and put it in the sink".
  void set_topic(const std::string& variable) { topic_ = variable; }
  /// A command or statement begins: its "it" is what was named last before it.
  void begin_clause() { clause_ = mentioned_.size(); }
  /// What the sentence so far was about, though it went on to name something else: "" where "it" would not be clear.
  void mention_again(const std::string& variable) { mentioned_.push_back(variable); }
  /// Whether such a thing was named.
  bool was_named_kind(const Domain& noun) const;
  /// Whether the text is one command, so that no "it" follows.
  bool says_one_thing() const { return plan_.message.size() == 1 && plan_.message[0].clauses.size() == 1; }

  /// Words for a noun phrase with its article and descriptions; nullopt, with the error set, where none can say it.
  std::optional<Words> phrase(const NounPhrase& phrase, Place place);
  /// The bare noun, as "more mugs" has it; `exact`: what it binds can be named from here on.
  std::optional<std::string> plural(const NounPhrase& phrase, Place place = {});
  bool is_countable(const Domain& noun) const;
  /// Whether the home has one such object, so that "the fridge" means it.
  bool is_alone(const Domain& noun) const;
  /// The same, or there are several and just one does not yet fulfill the goal: "the mug" to be washed.
  bool is_unique(const NounPhrase& phrase) const;
  /// Whether it will be named by "the", or is named already.
  bool will_be_the(const NounPhrase& phrase) const;
  /// Whether people carry it about.
  bool is_carried(const Domain& noun) const;
  /// "clean", "on that table", "filled with water".
  std::optional<std::string> complement(const Complement& complement, Place place);
  bool was_named(const std::string& variable) const;
  /// Whether such an object may be named by its use alone, "something to drink from".
  bool names_by_use(const Domain& noun) const;
  /// Whether it is watered rather than filled.
  bool is_plant(const Domain& noun) const;
  bool heats_food(const Domain& noun) const;  // a toaster, an oven
  /// Whether people put a lid on it rather than close it.
  bool has_lid(const Domain& noun) const;
  /// Whether people put things away in it: a cabinet, a drawer.
  bool puts_away(const Domain& noun) const;
  /// Whether it is sprinkled on food: salt, and what else the home's base has a shaker of.
  bool comes_from_a_shaker(const std::string& substance) const;
  /// The bare noun of one thing.
  std::optional<std::string> singular(const Domain& noun);
  /// The singular of what there are several of; from here on "the red one" means one of these.
  std::optional<std::string> several(const Domain& noun);
  /// Ends an alternative: what it named cannot be named again.
  std::size_t named_count() const { return named_.size(); }
  void forget_after(std::size_t count) { named_.resize(count); }

 private:
  struct Noun {
    std::string singular, plural;
    bool countable = true, function = false;
  };
  struct Named {
    std::string variable;
    Domain noun;
    bool vague = false;  // "that object" may mean it
    std::string use;     // "something to drink from", or ""
  };
  static bool is_plural(const Noun& noun);  // "the crackers", of which there is no one
  std::vector<std::string> nameless(const Domain& noun, AliasKind use) const;
  std::vector<std::string> uses(const Domain& noun) const;
  std::optional<Noun> noun(const Domain& domain, bool exact);
  bool may_mean_what_is_there(const std::string& name) const;
  std::optional<std::string> name_of(const Domain::Member& member, bool plural, bool& countable);
  std::optional<Words> again(const NounPhrase& phrase, const Noun& noun, Place place);
  bool is_what_it_means(const NounPhrase& phrase, Place place) const;
  /// What stands around a noun: "dirty", "that is on a desk", "nearest to the sink".
  struct Description {
    std::string before;     // an adjective with a blank, or ""
    std::string is;         // what follows "that is", or ""
    std::string directly;   // what follows directly, with a leading blank, or ""
    bool of_two = false;    // "the larger of the two mugs"
    bool short_is = false;  // "that's on the desk"
    std::string tail(bool plural) const {
      return directly + (is.empty() ? "" : (plural ? " that are " : short_is ? " that's " : " that is ") + is);
    }
  };
  std::optional<Description> describe(const NounPhrase& phrase, Place place);
  /// "some dirty mug", "every mug": what a proposition goes on to speak of.
  std::optional<Words> bound(const NounPhrase& phrase, const Noun& noun, const Description& description);
  std::string adjective(const Complement& modifier, bool two);
  std::string room_before(const Complement& modifier, const NounPhrase& said) const;
  bool says_room(const std::string& name) const;
  static bool takes_room(const std::string& name);
  std::optional<Words> first(const NounPhrase& phrase, const Noun& noun, Place place, const Description& description);
  std::optional<Words> all_but(const NounPhrase& phrase, const Noun& noun);
  /// "pants", where "the pair of pants" is meant; "" for others.
  std::string pair_name(const Domain& domain, const Noun& noun) const;
  bool says_one_of(const NounPhrase& phrase, const Noun& noun, Place place, bool described);
  /// The same as people say it, where they have other words.
  Words first_everyday(const NounPhrase& phrase, const Noun& noun, Place place, const Description& description);
  std::optional<Words> counted(const NounPhrase& phrase, const Noun& noun, Place place, const Description& description);
  std::string pick(std::initializer_list<const char*> choices);

  const Plan& plan_;
  const NounTable& lexicon_;
  Style style_;
  Wording wording_;
  Rng& rng_;
  bool is_one_again(const NounPhrase& phrase) const;
  int mentions_of(const Domain& noun) const;
  std::vector<Named> named_;
  std::vector<std::string> mentioned_;             // variables, the latest last; "": what "it" cannot mean
  std::size_t clause_ = 0;                         // mentions before the present clause
  std::string topic_;                              // a variable, or ""
  std::vector<Domain> several_, counted_;          // what "the red one" may be one of; "both mugs"
  std::map<std::string, NounTable::Name> chosen_;  // one name per category in a text
};

/// "two", "12"
std::string number_word(int number);

}  // namespace unietp
