// The C library's transcendental functions, for this program and for the shared libraries that it loads.
//
// glibc picks a variant of sin, exp and others by processor (with or without fused multiply-add), and the variants
// differ in the last bit, which is enough to move an object of a home. The definitions here take precedence over the C
// library's, for Bullet and FCL too, since CMakeLists.txt exports them. They call SLEEF's deterministic functions,
// which use no fused multiply-add and never look at the processor: equal arguments give equal bits everywhere, at most
// one unit in the last place from the exact value (tests/core/math_functions_test.cpp).
//
// They do not set errno, and asinh, acosh, log1p and pow already give infinity at the very largest doubles. Not here,
// because IEEE 754 or their definition leaves one result: sqrt, fma, fmod, remainder and rounding.

#include <cmath>

#include <sleef.h>

// Single precision is computed in double precision, where SLEEF is more exact.
#define UNIETP_OF_ONE(name, bound)                                                   \
  double name(double x) noexcept { return Sleef_cinz_##name##d1_##bound##purec(x); } \
  float name##f(float x) noexcept { return static_cast<float>(name(static_cast<double>(x))); }
#define UNIETP_OF_TWO(name, bound)                                                                \
  double name(double x, double y) noexcept { return Sleef_cinz_##name##d1_##bound##purec(x, y); } \
  float name##f(float x, float y) noexcept {                                                      \
    return static_cast<float>(name(static_cast<double>(x), static_cast<double>(y)));              \
  }

extern "C" {

UNIETP_OF_ONE(sin, u10)
UNIETP_OF_ONE(cos, u10)
UNIETP_OF_ONE(tan, u10)
UNIETP_OF_ONE(asin, u10)
UNIETP_OF_ONE(acos, u10)
UNIETP_OF_ONE(atan, u10)
UNIETP_OF_ONE(sinh, u10)
UNIETP_OF_ONE(cosh, u10)
UNIETP_OF_ONE(tanh, u10)
UNIETP_OF_ONE(asinh, u10)
UNIETP_OF_ONE(acosh, u10)
UNIETP_OF_ONE(atanh, u10)
UNIETP_OF_ONE(exp, u10)
UNIETP_OF_ONE(exp2, u10)
UNIETP_OF_ONE(exp10, u10)
UNIETP_OF_ONE(expm1, u10)
UNIETP_OF_ONE(log, u10)
UNIETP_OF_ONE(log2, u10)
UNIETP_OF_ONE(log10, u10)
UNIETP_OF_ONE(log1p, u10)
UNIETP_OF_ONE(cbrt, u10)
UNIETP_OF_ONE(erf, u10)
UNIETP_OF_ONE(erfc, u15)
UNIETP_OF_TWO(atan2, u10)
UNIETP_OF_TWO(pow, u10)
UNIETP_OF_TWO(hypot, u05)

// Compilers merge sin and cos of one value into this call at some levels of optimization, so it must agree with both.
void sincos(double x, double* sine, double* cosine) noexcept {
  *sine = sin(x);
  *cosine = cos(x);
}
void sincosf(float x, float* sine, float* cosine) noexcept {
  *sine = sinf(x);
  *cosine = cosf(x);
}

}  // extern "C"
