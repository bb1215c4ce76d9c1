#include "templates/phrasing.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <iterator>

#include "core/text.h"

namespace unietp {
namespace {

constexpr std::array kForms{
    SlotFormInfo{SlotForm::Plural, "plural", "mugs"},
    SlotFormInfo{SlotForm::Indefinite, "indefinite", "a mug"},
    SlotFormInfo{SlotForm::Definite, "definite", "the mug"},
    SlotFormInfo{SlotForm::Slice, "slice", "a slice of apple"},
    SlotFormInfo{SlotForm::On, "on", "on the table"},
    SlotFormInfo{SlotForm::Onto, "onto", "onto the table"},
    SlotFormInfo{SlotForm::Off, "off", "off the table"},
    SlotFormInfo{SlotForm::Inside, "inside", "inside the cabinet"},
    SlotFormInfo{SlotForm::Into, "into", "into the cabinet"},
    SlotFormInfo{SlotForm::OutOf, "out-of", "out of the cabinet"},
    SlotFormInfo{SlotForm::StoredIn, "stored-in", "stored in the cabinet"},
    SlotFormInfo{SlotForm::With, "with", "with the knife"},
};
static_assert([] {
  for (std::size_t i = 0; i < kForms.size(); ++i) {
    if (static_cast<std::size_t>(kForms[i].form) != i + 1) return false;
  }
  return kForms.back().form == SlotForm::With;
}());

Error malformed(std::size_t offset, std::string message) {
  return {Error::Kind::Parse, "", {1, static_cast<int>(offset) + 1}, std::move(message)};
}

struct Names {
  std::string singular, plural;
  bool countable = true;
};

Names names_of(const std::string& category, const Knowledge& knowledge) {
  if (const auto* known = knowledge.find(category)) return {known->display, known->plural, known->countable};
  const auto name = replace_all(lower(category), "_", " ");
  return {name, name + "s", true};
}

std::string indefinite(const Names& words) {
  if (!words.countable) return "some " + words.singular;
  return (starts_with_vowel_letter(words.singular) ? "an " : "a ") + words.singular;
}

std::string worded(SlotForm form, const Names& words) {
  switch (form) {
    case SlotForm::Bare:
      return words.singular;
    case SlotForm::Plural:
      return words.plural;
    case SlotForm::Indefinite:
      return indefinite(words);
    case SlotForm::Definite:
      return "the " + words.singular;
    case SlotForm::Slice:
      return "a slice of " + words.singular;
    default:  // the prepositions
      return replace_all(std::string(name_of(form)), "-", " ") + " the " + words.singular;
  }
}

}  // namespace

bool is_placeholder_name(std::string_view text) {
  return !text.empty() && std::isupper(static_cast<unsigned char>(text.front())) != 0 &&
         std::all_of(text.begin(), text.end(),
                     [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; });
}

std::span<const SlotFormInfo> slot_forms() { return kForms; }

std::string_view name_of(SlotForm form) {
  return form == SlotForm::Bare ? std::string_view() : kForms[static_cast<std::size_t>(form) - 1].name;
}

SlotReading read_slots(std::string_view text) {
  SlotReading reading;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] == '}')
      reading.errors.push_back(malformed(at, "'}' without a '{' before it; a slot is {A} or {A:plural}"));
    if (text[at] != '{') continue;
    const auto close = text.find_first_of("{}", at + 1);
    if (close == std::string_view::npos || text[close] == '{') {
      reading.errors.push_back(malformed(at, "this '{' has no '}'; a slot is {A} or {A:plural}"));
      continue;
    }
    const auto inner = text.substr(at + 1, close - at - 1);
    const auto colon = inner.find(':');
    Slot slot{std::string(inner.substr(0, colon)), SlotForm::Bare, at, close - at + 1};
    const std::string named(colon == std::string_view::npos ? "" : inner.substr(colon + 1));
    const auto* form = std::ranges::find(kForms, named, &SlotFormInfo::name);
    if (form != kForms.end()) slot.form = form->form;
    if (!is_placeholder_name(slot.placeholder)) {
      reading.errors.push_back(malformed(
          at, "malformed slot '{" + std::string(inner) + "}'; a slot is {A} or {A:form} with a declared placeholder"));
    } else if (colon != std::string_view::npos && form == kForms.end()) {
      std::vector<std::string> names;
      for (const auto& one : kForms) names.emplace_back(one.name);
      const auto near = nearest_name(named, names);
      reading.errors.push_back(malformed(at, "unknown form '" + named + "' in a slot; accepted: " + join(names, ", ") +
                                                 (near.empty() ? "" : "; did you mean '" + near + "'?")));
    } else {
      reading.slots.push_back(std::move(slot));
    }
    at = close;
  }
  return reading;
}

std::string fill_phrasing(std::string_view text, const std::vector<std::pair<std::string, std::string>>& binding,
                          const Knowledge& knowledge) {
  std::string filled;
  std::size_t at = 0;
  for (const auto& slot : read_slots(text).slots) {
    filled += text.substr(at, slot.offset - at);
    at = slot.offset + slot.length;
    const auto bound =
        std::find_if(binding.begin(), binding.end(), [&](const auto& pair) { return pair.first == slot.placeholder; });
    if (bound == binding.end()) {
      filled += text.substr(slot.offset, slot.length);
    } else {
      filled += worded(slot.form, names_of(bound->second, knowledge));
    }
  }
  filled += text.substr(at);
  if (!filled.empty()) filled.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(filled.front())));
  return filled;
}

}  // namespace unietp
