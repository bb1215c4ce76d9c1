#pragma once

#include <string>
#include <vector>

namespace unietp::python {

/// A call of a mathematical function from a shared library that this module needs.
struct MathBinding {
  std::string library;   // file name, "libBulletDynamics-float64.so.3.24"
  std::string function;  // "sin"
  bool own = false;      // goes to core/math_functions.cpp
};

/// Makes the shared libraries that this module needs (Bullet, FCL, Embree) call core/math_functions.cpp. In a program
/// the linker does that, since the definitions of a program take precedence; those of a module that Python loads do
/// not, and the libraries would call the C library, whose results depend on the processor. RTLD_DEEPBIND would do it
/// too, but then a preloaded allocator (LD_PRELOAD=libjemalloc.so) ends the process, and libraries that another module
/// has loaded before keep what they are bound to.
/// Changes the slots of those libraries' relocation tables. Call it once, before anything else runs.
/// Throws std::runtime_error when a slot cannot be written.
void bind_math_functions();

/// What the slots hold now, in the order of loading. For tests.
std::vector<MathBinding> math_bindings();

}  // namespace unietp::python
