#include "sense/kinds.h"

#include <algorithm>

#include "akb/row_reader.h"
#include "core/files.h"
#include "core/limits.h"

namespace unietp {

Kinds::Kinds(std::vector<Kind> kinds) : kinds_(std::move(kinds)) {
  for (std::size_t i = 0; i < kinds_.size(); ++i) by_name_.emplace(kinds_[i].name, i);
  for (const Kind& kind : kinds_) parents_.push_back(number_of(kind.parent));
}

std::size_t Kinds::number_of(std::string_view name) const {
  const auto found = by_name_.find(name);
  return found == by_name_.end() ? kNone : found->second;
}

const Kind* Kinds::find(std::string_view name) const {
  const std::size_t number = number_of(name);
  return number == kNone ? nullptr : &kinds_[number];
}

std::vector<const Kind*> Kinds::lineage(std::string_view name) const {
  std::vector<const Kind*> line;
  for (std::size_t at = number_of(name); at != kNone; at = parents_[at]) line.push_back(&kinds_[at]);
  return line;
}

std::vector<const Kind*> Kinds::narrower(std::string_view name) const {
  std::vector<const Kind*> found;
  for (const auto& kind : kinds_) {
    if (!name.empty() && kind.parent == name) found.push_back(&kind);
  }
  return found;
}

bool Kinds::is_a(std::string_view kind, std::string_view wider) const {
  const std::size_t top = number_of(wider);
  std::size_t at = number_of(kind);
  while (at != top && at != kNone) at = parents_[at];
  return at != kNone;
}

std::string Kinds::piece_of(const std::string& kind) const {
  const Kind* known = find(kind);
  return known == nullptr || known->piece.empty() ? kind : known->piece;
}

std::string Kinds::usual_relation(std::string_view place) const {
  const Kind* known = find(place);
  return known != nullptr && known->relation.starts_with("in") ? "in" : "on";
}

std::string Kinds::place_role(std::string_view relation, std::string_view place) const {
  const Kind* known = find(place);
  const bool alike = known != nullptr && (known->relation == "on" || known->relation == "in");
  return (alike ? known->relation : std::string(relation)) + ":" + std::string(place);
}

namespace {

/// Whether going up from the kind ends at a root, in few enough steps for those who go up by recursion.
bool ends(const Kinds& kinds, const Kind& kind) {
  const Kind* at = &kind;
  for (std::size_t steps = 0; steps <= limits::kKindDepth; ++steps) {
    if (at->parent.empty()) return true;
    at = kinds.find(at->parent);
    if (at == nullptr) return true;  // reported as an unknown parent
  }
  return false;
}

}  // namespace

Kinds read_kinds(const std::filesystem::path& path, std::vector<Error>& errors) {
  const auto text = read_file(path);
  if (!text) {
    errors.push_back(text.error());
    return {};
  }
  RowReader row(
      path.string(), *text,
      {"name", "singular", "plural", "parent", "purpose", "relation", "piece", "personal", "several", "source"},
      errors);
  std::vector<Kind> kinds;
  std::vector<std::string> names;
  bool tree = true;
  for (const auto& cells : row.rows()) {
    row.at(cells);
    Kind kind{row.required("name"), row.required("singular"),      row.required("plural"),
              row.text("parent"),   row.required("purpose"),       row.text("relation"),
              row.text("piece"),    row.text("personal") == "yes", row.text("several") == "yes"};
    (void)row.required("source");
    for (const auto* column : {"personal", "several"}) {
      if (!row.text(column).empty() && row.text(column) != "yes") row.fail(column, "expected nothing or yes");
    }
    const bool twice = std::find(names.begin(), names.end(), kind.name) != names.end();
    if (twice) row.fail("name", "'" + kind.name + "' stands twice");
    tree = tree && !twice && !kind.name.empty();
    static const std::vector<std::string> relations{"", "on", "in", "on|in", "in|on"};
    if (std::find(relations.begin(), relations.end(), kind.relation) == relations.end())
      row.fail("relation", "'" + kind.relation + "' is no relation; expected nothing, on, in, on|in or in|on");
    names.push_back(kind.name);
    kinds.push_back(std::move(kind));
  }
  Kinds all(std::move(kinds));
  std::size_t at = 0, roots = 0;
  for (const auto& cells : row.rows()) {
    row.at(cells);
    const Kind& kind = all.all()[at++];
    if (kind.parent.empty()) {
      if (++roots > 1) row.fail("parent", "'" + kind.name + "' has no parent, as another kind; expected one root");
    } else if (all.find(kind.parent) == nullptr) {
      row.fail("parent", "'" + kind.parent + "' is not a kind of this table");
    } else if (!ends(all, kind)) {
      tree = false;
      row.fail("parent", "'" + kind.name + "' is above itself, or has more than " + std::to_string(limits::kKindDepth) +
                             " kinds above it");
    }
    if (!kind.piece.empty() && all.find(kind.piece) == nullptr)
      row.fail("piece", "'" + kind.piece + "' is not a kind of this table");
  }
  return tree ? all : Kinds();  // whoever goes up or down a circle never ends
}

}  // namespace unietp
