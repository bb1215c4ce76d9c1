// docs/limits.md lists every bound of core/limits.h with its value.
#include <charconv>
#include <cmath>
#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/files.h"
#include "core/text.h"

namespace unietp {
namespace {

const std::filesystem::path kCheckout = UNIETP_SOURCE_DIR;

double number_of(const std::string& digits) {
  double value = -1;
  const auto [end, failure] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  EXPECT_TRUE(failure == std::errc{} && end == digits.data() + digits.size()) << digits;
  return value;
}

/// "256", "1'000", "std::size_t{8} << 20", "64 << 20" or the name of an earlier constant.
double value_of(std::string expression, const std::map<std::string, double>& known) {
  if (const auto found = known.find(expression); found != known.end()) return found->second;
  expression = replace_all(replace_all(replace_all(expression, "'", ""), "std::size_t{", ""), "}", "");
  const auto shift = expression.find(" << ");
  const double value = number_of(expression.substr(0, shift));
  return shift == std::string::npos ? value : value * std::exp2(number_of(expression.substr(shift + 4)));
}

std::map<std::string, double> bounds_of_header() {
  std::map<std::string, double> bounds;
  const std::string text = *read_file(kCheckout / "core" / "limits.h");
  for (const auto& line : split(text, '\n')) {
    if (!line.starts_with("inline constexpr ")) continue;
    std::string list = line.substr(0, line.find(';'));
    list = list.substr(list.find(" k") + 1);
    for (const auto& one : split(list, ',')) {
      const auto sides = split(one, '=');
      EXPECT_EQ(sides.size(), 2U) << line;
      bounds[std::string(trim(sides.front()))] = value_of(std::string(trim(sides.back())), bounds);
    }
  }
  return bounds;
}

/// By constant, from the rows `| what | 8 MiB | `kLineBytes` |`.
std::map<std::string, double> bounds_of_page() {
  const std::map<std::string, double> units{{"", 1},
                                            {"bytes", 1},
                                            {"m", 1},
                                            {"m2", 1},
                                            {"kg", 1},
                                            {"KiB", 1024},
                                            {"Mi", std::exp2(20)},
                                            {"MiB", std::exp2(20)}};
  std::map<std::string, double> bounds;
  for (const auto& line : split(*read_file(kCheckout / "docs" / "limits.md"), '\n')) {
    const auto cells = split(line, '|');
    if (cells.size() != 5 || trim(cells[3]).size() < 4 || trim(cells[3]).front() != '`') continue;
    const auto accepted = split(std::string(trim(cells[2])), ' ');
    const auto unit = units.find(accepted.size() > 1 ? accepted[1] : "");
    EXPECT_NE(unit, units.end()) << line;
    const std::string name(trim(cells[3]));
    if (unit != units.end()) bounds[name.substr(1, name.size() - 2)] = number_of(accepted[0]) * unit->second;
  }
  return bounds;
}

TEST(Limits, ThePageListsEachBoundWithItsValue) {
  const auto header = bounds_of_header();
  EXPECT_GT(header.size(), 40U);
  EXPECT_THAT(bounds_of_page(), ::testing::ContainerEq(header));
}

}  // namespace
}  // namespace unietp
