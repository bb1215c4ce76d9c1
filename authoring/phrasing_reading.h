#pragma once

#include <string>
#include <vector>

#include "generator/specification.h"
#include "resources/resources.h"
#include "templates/template.h"

namespace unietp {

/// Whether texts in a phrasing of a template's `(instruction …)` are read back as the goal, so that instructions have
/// it.
struct PhrasingReading {
  bool readable = false;
  std::string text;  // such a text; "" where the slots fit no binding that was tried
  std::string why;   // what is wrong with the text; "" when nothing is
};

/// One for each phrasing, in their order: read back for some binding on some simulator that the template claims,
/// without a home. Deterministic.
std::vector<PhrasingReading> read_phrasings(const Template& source, const std::vector<Backend>& backends);

/// Texts of a goal in one style.
struct StyleTexts {
  Style style = Style::Direct;
  std::vector<std::string> texts;
};

/// Up to `count` different texts for each style that the goal fits in a home, in the order of the enumeration, without
/// those that it has no text in. `plain`: as its template gives it; the goal of another style may accept or describe
/// more. `home`: at the start of such a task. Deterministic in rng.
std::vector<StyleTexts> texts_by_style(const Template& source, const Specification& plain, const Backend& backend,
                                       const Scene& home, std::size_t count, Rng rng);

}  // namespace unietp
