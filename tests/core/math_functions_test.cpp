#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <mpfr.h>

#include "core/digest.h"
#include "core/rng.h"

// The exact values come from MPFR, which rounds every function correctly at any precision and works with integers only.
namespace unietp {
namespace {

using InMpfr = int(mpfr_t, mpfr_srcptr, mpfr_rnd_t);
using InMpfrOfTwo = int(mpfr_t, mpfr_srcptr, mpfr_srcptr, mpfr_rnd_t);

/// A function of one argument in both precisions, with the range of everyday arguments and the bound of its error in
/// units in the last place that SLEEF states.
struct OfOne {
  const char* name;
  double (*in_double)(double);
  float (*in_single)(float);
  InMpfr* exact;
  double low, high;
  double bound = 1;
};

struct OfTwo {
  const char* name;
  double (*in_double)(double, double);
  float (*in_single)(float, float);
  InMpfrOfTwo* exact;
  double low, high;  // of the first argument; the second lies in [-high, high]
  double bound = 1;
};

// clang-format off
const std::vector<OfOne> kOfOne = {
    {"sin", ::sin, ::sinf, mpfr_sin, -10, 10},          {"cos", ::cos, ::cosf, mpfr_cos, -10, 10},
    {"tan", ::tan, ::tanf, mpfr_tan, -10, 10},          {"asin", ::asin, ::asinf, mpfr_asin, -1, 1},
    {"acos", ::acos, ::acosf, mpfr_acos, -1, 1},        {"atan", ::atan, ::atanf, mpfr_atan, -10, 10},
    {"sinh", ::sinh, ::sinhf, mpfr_sinh, -80, 80},      {"cosh", ::cosh, ::coshf, mpfr_cosh, -80, 80},
    {"tanh", ::tanh, ::tanhf, mpfr_tanh, -5, 5},        {"asinh", ::asinh, ::asinhf, mpfr_asinh, -100, 100},
    {"acosh", ::acosh, ::acoshf, mpfr_acosh, 1, 100},   {"atanh", ::atanh, ::atanhf, mpfr_atanh, -1, 1},
    {"exp", ::exp, ::expf, mpfr_exp, -80, 80},          {"exp2", ::exp2, ::exp2f, mpfr_exp2, -120, 120},
    {"exp10", ::exp10, ::exp10f, mpfr_exp10, -37, 37},  {"expm1", ::expm1, ::expm1f, mpfr_expm1, -80, 80},
    {"log", ::log, ::logf, mpfr_log, 0, 100},           {"log2", ::log2, ::log2f, mpfr_log2, 0, 100},
    {"log10", ::log10, ::log10f, mpfr_log10, 0, 100},   {"log1p", ::log1p, ::log1pf, mpfr_log1p, -1, 100},
    {"cbrt", ::cbrt, ::cbrtf, mpfr_cbrt, -100, 100},    {"erf", ::erf, ::erff, mpfr_erf, -4, 4},
    {"erfc", ::erfc, ::erfcf, mpfr_erfc, -4, 4, 1.5},
};
const std::vector<OfTwo> kOfTwo = {
    {"atan2", ::atan2, ::atan2f, mpfr_atan2, -10, 10},
    {"pow", ::pow, ::powf, mpfr_pow, 0, 20},
    {"hypot", ::hypot, ::hypotf, mpfr_hypot, -100, 100, 0.5001},
};
// clang-format on

class Exact {
 public:
  Exact() { mpfr_init2(value_, 160); }
  explicit Exact(double value) : Exact() { mpfr_set_d(value_, value, MPFR_RNDN); }
  Exact(const Exact&) = delete;
  Exact& operator=(const Exact&) = delete;
  ~Exact() { mpfr_clear(value_); }
  mpfr_ptr get() { return value_; }

 private:
  mpfr_t value_;
};

/// How far `result` is from the exact value, in units in the last place of T; infinite where one is not a number, has
/// the other sign or is infinite and the other is not.
template <class T>
double error_in_ulps(T result, Exact& exact) {
  using Limits = std::numeric_limits<T>;
  constexpr double kNever = std::numeric_limits<double>::infinity();
  const bool neither = mpfr_nan_p(exact.get()) != 0;
  if (neither || std::isnan(result)) return neither && std::isnan(result) ? 0 : kNever;
  const double nearest = mpfr_get_d(exact.get(), MPFR_RNDN);
  const T rounded = static_cast<T>(nearest);
  if (std::signbit(rounded) != std::signbit(result)) return kNever;
  if (result == rounded && (std::isinf(result) || result == 0)) return 0;
  if (std::isinf(result) || mpfr_inf_p(exact.get()) != 0) return kNever;
  const auto exponent = std::max<long>(mpfr_zero_p(exact.get()) != 0 ? Limits::min_exponent : mpfr_get_exp(exact.get()),
                                       Limits::min_exponent);
  Exact error;
  mpfr_sub_d(error.get(), exact.get(), static_cast<double>(result), MPFR_RNDN);
  mpfr_mul_2si(error.get(), error.get(), Limits::digits - exponent, MPFR_RNDN);
  return std::abs(mpfr_get_d(error.get(), MPFR_RNDN));
}

template <class T>
double error_of(const OfOne& function, T x) {
  Exact exact, argument(static_cast<double>(x));
  function.exact(exact.get(), argument.get(), MPFR_RNDN);
  if constexpr (std::is_same_v<T, double>)
    return error_in_ulps(function.in_double(x), exact);
  else
    return error_in_ulps(function.in_single(x), exact);
}

template <class T>
double error_of(const OfTwo& function, T x, T y) {
  Exact exact, first(static_cast<double>(x)), second(static_cast<double>(y));
  function.exact(exact.get(), first.get(), second.get(), MPFR_RNDN);
  if constexpr (std::is_same_v<T, double>)
    return error_in_ulps(function.in_double(x, y), exact);
  else
    return error_in_ulps(function.in_single(x, y), exact);
}

TEST(MathFunctions, AreWithinTheirBoundOfTheExactValue) {
  Rng rng(1);
  for (const auto& function : kOfOne) {
    for (int i = 0; i < 1500; ++i) {
      const double small = std::ldexp(1.0, -static_cast<int>(rng.below(30)));
      const double x = rng.uniform(function.low, function.high) * (function.low == 1 ? 1 : small);
      EXPECT_LE(error_of(function, x), function.bound) << function.name << " of " << x;
      EXPECT_LE(error_of(function, static_cast<float>(x)), function.bound) << function.name << "f of " << x;
    }
  }
  for (const auto& function : kOfTwo) {
    for (int i = 0; i < 3000; ++i) {
      const double x = rng.uniform(function.low, function.high), y = rng.uniform(-function.high, function.high);
      EXPECT_LE(error_of(function, x, y), function.bound) << function.name << " of " << x << ", " << y;
      EXPECT_LE(error_of(function, static_cast<float>(x), static_cast<float>(y)), function.bound)
          << function.name << "f of " << x << ", " << y;
    }
  }
}

template <class T>
std::vector<T> special_values() {
  using Limits = std::numeric_limits<T>;
  std::vector<T> values{Limits::quiet_NaN()};
  for (const T size : {T(0), T(0.5), T(1), T(2), T(3), Limits::min(), T(1e30), Limits::infinity()}) {
    values.push_back(size);
    values.push_back(-size);
  }
  return values;
}

template <class T>
void expect_agreement_at_special_values() {
  for (const T x : special_values<T>()) {
    for (const auto& function : kOfOne) {
      EXPECT_LE(error_of(function, x), function.bound) << function.name << " of " << x;
    }
    for (const auto& function : kOfTwo) {
      for (const T y : special_values<T>()) {
        EXPECT_LE(error_of(function, x, y), function.bound) << function.name << " of " << x << ", " << y;
      }
    }
  }
}

TEST(MathFunctions, AgreeWithTheExactValueAtZeroOneInfinityAndWhatIsNoNumber) {
  expect_agreement_at_special_values<double>();
  expect_agreement_at_special_values<float>();
}

TEST(MathFunctions, SineAndCosineTogetherAreTheBitsOfEachAlone) {
  Rng rng(2);
  for (int i = 0; i < 1000; ++i) {
    const double x = rng.uniform(-100, 100);
    double sine = 0, cosine = 0;
    ::sincos(x, &sine, &cosine);
    EXPECT_EQ(sine, kOfOne[0].in_double(x)) << x;  // a direct call would be merged into sincos
    EXPECT_EQ(cosine, kOfOne[1].in_double(x)) << x;
  }
}

template <class T>
void append_bits(std::string& to, T value) {
  const auto bytes = std::bit_cast<std::array<char, sizeof(T)>>(value);
  to.append(bytes.data(), bytes.size());
}

// Fails where another version of SLEEF, another compiler or another processor gives another last bit.
TEST(MathFunctions, GiveTheBitsThatDataSetsWereMadeWith) {
  Rng rng(3);
  std::string bits;
  for (const auto& function : kOfOne) {
    for (int i = 0; i < 300; ++i) {
      const double x = rng.uniform(function.low, function.high);
      append_bits(bits, function.in_double(x));
      append_bits(bits, function.in_single(static_cast<float>(x)));
    }
  }
  for (const auto& function : kOfTwo) {
    for (int i = 0; i < 300; ++i) {
      const double x = rng.uniform(function.low, function.high), y = rng.uniform(-function.high, function.high);
      append_bits(bits, function.in_double(x, y));
      append_bits(bits, function.in_single(static_cast<float>(x), static_cast<float>(y)));
    }
  }
  EXPECT_EQ(sha256(bits), "629df4c3b42af46590cf0893cdcfc6a7348d39684770cb76799586154172afcf");
}

}  // namespace
}  // namespace unietp
