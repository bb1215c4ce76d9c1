#pragma once

#include <nanobind/nanobind.h>

namespace unietp::python {

// Each defines the classes and functions of one file in the module.
void define_catalog(nanobind::module_& module);      // SimulatorData, TaskSource, Task
void define_data_files(nanobind::module_& module);   // RecordLines; homes and manifest of a data set
void define_settings(nanobind::module_& module);     // names and presets
void define_environment(nanobind::module_& module);  // Environment, Snapshot
void define_batch(nanobind::module_& module);        // Batch

}  // namespace unietp::python
