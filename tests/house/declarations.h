#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace unietp {

/// Something that a header offers: a type, function, constant or alias of a namespace, or a public member of a type.
struct Declaration {
  int line = 0;
  std::string text;  // on one line, without comments and texts; of a type with "{}" for its body, of a function without
  bool is_member = false;  // of a type
  bool commented = false;  // by a comment above it or above the group that it is in, or at the end of a line of it
};

/// What a header of this project offers, in order. A group is a run of declarations without an empty line. Reads the
/// layout that clang-format gives; macros are skipped.
std::vector<Declaration> public_declarations(std::string_view header);

/// Whether a reader needs words for it. Not for forward declarations, data members and nested types (the comment of the
/// type around them is for them), constructors, operators, overrides and members defined behind their type, nor for
/// `size`, `empty`, `begin` and `end`, which mean the same everywhere.
bool needs_comment(const Declaration& declaration);

}  // namespace unietp
