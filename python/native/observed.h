#pragma once

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>

#include <cstdint>
#include <string>
#include <vector>

#include "environment/environment.h"
#include "python/native/array_form.h"
#include "simulation/channels.h"
#include "simulation/picture.h"

namespace unietp::python {

/// Arrays of `count` environments, one after the other, in memory of their own that goes to Python without a copy.
class ArrayBlock {
 public:
  ArrayBlock(std::size_t count, std::size_t rows, std::size_t text_bytes);
  /// The part of one environment.
  ObservationArrays part(std::size_t environment);
  /// {"things", "held", "last", "counts", "instruction"}: arrays of numpy that own the memory; with a first dimension
  /// `count` when `batched`. Call it once, with the interpreter's lock.
  nanobind::dict to_python(bool batched) &&;

 private:
  std::size_t count_, rows_, text_bytes_;
  std::vector<std::int32_t> things_, held_, last_, counts_;
  std::vector<std::uint8_t> instruction_;
};

/// An array of numpy (its length) that owns the numbers.
nanobind::object array_of(std::vector<double> numbers);
nanobind::object array_of(std::vector<std::uint8_t> numbers);
/// An array uint8 (height, width, 3).
nanobind::object to_python(Picture picture);

/// {"depth": float32 (height, width), "normals": float32 (height, width, 3), "instances": int32 (height, width), "ids":
/// list of str}; `instances` holds positions in `ids`, the first of which is "" for walls, floor and ceiling. `ids`:
/// of the nodes, in their order.
nanobind::dict to_python(Channels channels, const std::vector<std::string>& ids);

/// What the executed actions came to and changed, privileged: a list of {"action", "args", "success", "failure",
/// "feedback", "counted", "changes"}, as in demonstrations/<mode>.jsonl.
nlohmann::ordered_json executed_to_json(const std::vector<ExecutedAction>& executed);

}  // namespace unietp::python
