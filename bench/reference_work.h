#pragma once

#include <ctime>
#include <map>
#include <string>

#include "core/rng.h"

namespace unietp {

/// Of all threads of this process.
inline double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Processor seconds for a fixed piece of work of the standard library alone: what a run takes is told in these too, so
/// that runs of different hours or machines can be compared.
inline double reference_seconds() {
  const double start = processor_seconds();
  std::map<std::string, double> table;
  Rng rng(1);
  for (int i = 0; i < 100'000; ++i) table.emplace("object_" + std::to_string(rng.next()), rng.unit());
  double sum = 0;
  for (const auto& [name, value] : table) sum += value;
  volatile double kept = sum;  // so that the work is done
  (void)kept;
  return processor_seconds() - start;
}

}  // namespace unietp
