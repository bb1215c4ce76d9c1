#pragma once

#include "dataset/configuration.h"
#include "generator/weighted_binding.h"
#include "resources/resources.h"

namespace unietp {

/// Accepts categories with which a template's goal still makes at least so much sense; everything for Senseless. The
/// template and the resources must outlive it.
BindingCheck at_least(Grade least, const Template& source, const Resources& resources, Simulator simulator);

/// The best grade, at most `wanted`, that some binding of a template on a simulator has, whatever homes offer; nullopt
/// when it has none at all.
std::optional<Grade> best_grade(Grade wanted, const Template& source, const Resources& resources, Simulator simulator,
                                const Binding& fixed);

/// How much sense a task makes.
TaskSense sense_of_task(const Specification& specification, const Resources& resources);

}  // namespace unietp
