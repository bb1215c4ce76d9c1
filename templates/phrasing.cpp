#include "templates/phrasing.h"

#include <algorithm>
#include <cctype>
#include <iterator>

#include "core/text.h"

namespace unietp {
namespace {

std::string form_list() {
  std::vector<std::string> names;
  for (const auto& form : slot_forms()) names.emplace_back(form.name);
  return join(names, ", ");
}

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

std::string worded(const std::string& form, const Names& words) {
  if (form.empty()) return words.singular;
  if (form == "plural") return words.plural;
  if (form == "indefinite") return indefinite(words);
  if (form == "definite") return "the " + words.singular;
  if (form == "slice") return "a slice of " + words.singular;
  return replace_all(form, "-", " ") + " the " + words.singular;  // the prepositions
}

}  // namespace

bool is_placeholder_name(std::string_view text) {
  return !text.empty() && std::isupper(static_cast<unsigned char>(text.front())) != 0 &&
         std::all_of(text.begin(), text.end(),
                     [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; });
}

const std::vector<SlotForm>& slot_forms() {
  static const std::vector<SlotForm> kForms = {
      {"plural", "mugs"},
      {"indefinite", "a mug"},
      {"definite", "the mug"},
      {"slice", "a slice of apple"},
      {"on", "on the table"},
      {"onto", "onto the table"},
      {"off", "off the table"},
      {"inside", "inside the cabinet"},
      {"into", "into the cabinet"},
      {"out-of", "out of the cabinet"},
      {"stored-in", "stored in the cabinet"},
      {"with", "with the knife"},
  };
  return kForms;
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
    Slot slot{std::string(inner.substr(0, colon)), "", at, close - at + 1};
    if (colon != std::string_view::npos) slot.form = inner.substr(colon + 1);
    const auto& forms = slot_forms();
    const bool known_form =
        std::any_of(forms.begin(), forms.end(), [&](const SlotForm& f) { return f.name == slot.form; });
    if (!is_placeholder_name(slot.placeholder)) {
      reading.errors.push_back(malformed(
          at, "malformed slot '{" + std::string(inner) + "}'; a slot is {A} or {A:form} with a declared placeholder"));
    } else if (colon != std::string_view::npos && !known_form) {
      std::vector<std::string> names;
      for (const auto& form : forms) names.emplace_back(form.name);
      const auto near = nearest_name(slot.form, names);
      reading.errors.push_back(malformed(at, "unknown form '" + slot.form + "' in a slot; accepted: " + form_list() +
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
