#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "environment/task.h"
#include "python/native/array_form.h"
#include "resources/resources.h"

namespace unietp::python {

/// The program's data, read once.
struct Catalog {
  std::shared_ptr<const Resources> resources;
  AllSimulatorData simulators;
  Vocabulary vocabulary;  // the categories of all simulators and the types of rooms
};

/// How the observations of an environment are written as arrays, and its actions as numbers.
struct Encoding {
  std::shared_ptr<const Catalog> catalog;
  std::vector<std::string> actions;  // names by number
  std::size_t rows = 0;              // of the array `things`
  std::size_t text_bytes = 0;        // of the array `instruction`

  /// Of the observations.
  ArrayForm form() const { return {catalog->vocabulary, actions, rows}; }
};

/// A task as Python holds it.
struct TaskHandle {
  SharedTask task;
};

}  // namespace unietp::python
