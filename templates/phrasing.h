#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "akb/knowledge.h"
#include "core/result.h"

namespace unietp {

/// The form of the words in a slot.
enum class SlotForm : std::uint8_t {
  Bare,
  Plural,
  Indefinite,
  Definite,
  Slice,
  On,
  Onto,
  Off,
  Inside,
  Into,
  OutOf,
  StoredIn,
  With,
};
std::string_view name_of(SlotForm form);  // "out-of"; "" for Bare

/// A slot of a reference phrasing: `{A}` or `{A:form}`.
struct Slot {
  std::string placeholder;  // "A"
  SlotForm form = SlotForm::Bare;
  std::size_t offset = 0;  // of its `{` in the text, in bytes
  std::size_t length = 0;  // up to and including `}`
};

/// A form that a slot may name, with an example: "plural" -> "mugs".
struct SlotFormInfo {
  SlotForm form;
  std::string_view name, example;
};
/// All but Bare, in the order of the enum.
std::span<const SlotFormInfo> slot_forms();
bool is_placeholder_name(std::string_view text);  // "A", "Sink_2"

/// The slots of a phrasing, and everything that is malformed in it (pos.column is the offset in the text, from 1).
struct SlotReading {
  std::vector<Slot> slots;
  std::vector<Error> errors;
};
SlotReading read_slots(std::string_view text);

/// The phrasing with the words of the categories in its slots: "Put two mugs into the cabinet." A slot whose
/// placeholder is not named stays as it is. A category that the knowledge base does not know (a room type) is worded
/// by its own name in lower case.
std::string fill_phrasing(std::string_view text, const std::vector<std::pair<std::string, std::string>>& binding,
                          const Knowledge& knowledge);

}  // namespace unietp
