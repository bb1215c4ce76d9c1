#pragma once

#include "akb/knowledge.h"

namespace unietp {

/// The committed tables of a simulator, compiled and read once for the test program; fails the test when they do not.
const Knowledge& real_tables(Simulator simulator);

}  // namespace unietp
