#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"

namespace unietp {

/// The English that instructions are written in. Both are read.
enum class English { Us, Gb };

/// What a word at the end of a name tells of the thing: a row of name_uses.csv.
enum class NameUse : std::uint8_t {
  HasLid,     // it is opened by its lid
  Plant,      // it grows
  HeatsFood,  // food is heated in or on it
  PutsAway,   // what is put in it is put away
  HasTop,     // "on top of" it is said, not "on" it
};

/// What people call things every day, where the knowledge base calls them otherwise, and which of its synonyms texts do
/// not use. Read only after loading; with no rows, things are called what the knowledge base calls them.
class EverydayNames {
 public:
  /// A row of everyday_names.csv: what people call a thing in singular.
  struct Forms {
    std::string us, gb;
  };
  /// A row of rare_names.csv: in which English people say it.
  struct Use {
    bool us = false, gb = false;
  };

  EverydayNames() = default;
  /// A row of look_alikes.csv: other things that people may call so, too, by what the knowledge base calls them, or
  /// "kind raw_meat" for all of a kind of data/sense/kinds.csv.
  using Others = std::vector<std::string>;
  /// A row of name_uses.csv.
  using Uses = std::vector<NameUse>;
  EverydayNames(std::map<std::string, Forms, std::less<>> names, std::map<std::string, Use, std::less<>> rare,
                std::map<std::string, Others, std::less<>> look_alikes = {},
                std::map<std::string, Uses, std::less<>> uses = {});

  /// What people call what the knowledge base calls `name`, in singular: "stove", or "cooker" in Britain, for "oven
  /// stove". "" where they call it so, too. Valid as long as this object.
  std::string_view of(std::string_view name, English english) const;
  /// Whether a text may use a synonym of the knowledge base: false for what only a dictionary, a shop or the other
  /// English says.
  bool is_said(std::string_view synonym, English english) const;
  /// What a home must not have for the name of a thing, or a phrase, to mean this thing: a nightstand is a side table,
  /// too. As in the table; empty for what has no row.
  std::span<const std::string> look_alikes(std::string_view name) const;
  /// Whether this word is one of such things.
  bool is_word_for(std::string_view word, NameUse use) const;
  /// Whether a name ends in a word for such things: "kitchen cabinet".
  bool ends_as(std::string_view name, NameUse use) const;

 private:
  std::map<std::string, Forms, std::less<>> names_;  // by what the knowledge base says
  std::map<std::string, Use, std::less<>> rare_;     // by synonym
  std::map<std::string, Others, std::less<>> look_alikes_;
  std::map<std::string, Uses, std::less<>> uses_;  // by word
};

/// Reads everyday_names.csv and rare_names.csv (name,us,gb,source), look_alikes.csv (name,others,source) and
/// name_uses.csv (name,uses,source) of a folder (data/english); several names, others and uses are separated by `|`.
/// Errors are appended, with file, line and column: Io, Parse, Schema; Schema for a name that stands twice.
EverydayNames read_everyday_names(const std::filesystem::path& folder, std::vector<Error>& errors);

}  // namespace unietp
