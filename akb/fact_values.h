#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/geometry.h"

namespace unietp {

// The values of facts as override files write them; nothing where a text is not such a value.

/// > 0 and <= `most`.
std::optional<double> number_in(std::string_view text, double most);
/// A whole number >= 1.
std::optional<int> count_in(std::string_view text);
/// `0.3 x 0.2 x 0.1`: width, depth, height in meters, each > 0 and <= limits::kCategory_m.
std::optional<Vec3> size_in(const std::string& text);
/// `true` or `false`.
std::optional<bool> flag_in(std::string_view text);
/// Words joined by |, each one of `accepted` unless that is empty. An empty text holds none.
std::optional<std::vector<std::string>> words_in(const std::string& text, const std::vector<std::string>& accepted);
/// As `mug.n.04`.
bool is_synset(std::string_view text);

}  // namespace unietp
