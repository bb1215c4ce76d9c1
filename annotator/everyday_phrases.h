#pragma once

#include <string>

#include "annotator/noun_table.h"

namespace unietp {

/// "The dining room table" for "the dining table in the dining room"; tokens_of takes it back.
std::string with_room_tables(std::string text);

/// "On top of the cabinet" for "on the cabinet", which is heard as a slip for "in".
std::string with_tops(std::string text, const NounTable& nouns);

/// "Close one of the books" for "close a book", "turn one of the lamps off": of what is open or on people mean certain
/// ones.
std::string with_one_of(std::string text, const NounTable& nouns);

/// "The zipped-up backpack": nobody calls one closed.
std::string with_zips(std::string text);

}  // namespace unietp
