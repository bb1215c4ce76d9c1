// The same bytes whichever variants of its routines glibc picks for the processor; `checks/cpus` compares all homes and
// many tasks, also on an emulated processor.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <sstream>

#include "core/files.h"
#include "program.h"

namespace unietp {
namespace {

// Each is defined to give one result, by IEEE 754 or by the C standard; `_LIB_VERSION` and the like are variables.
const std::set<std::string> kExactInLibm{
    "ceil",      "ceilf",   "floor",        "floorf",     "trunc",      "truncf",   "round",     "roundf",
    "rint",      "rintf",   "lrint",        "lrintf",     "lround",     "llround",  "nearbyint", "sqrt",
    "sqrtf",     "fmod",    "fmodf",        "remainder",  "fma",        "fmin",     "fmax",      "frexp",
    "frexpl",    "ldexp",   "ldexpl",       "modf",       "scalbn",     "copysign", "fdim",      "signgam",
    "__signgam", "matherr", "_LIB_VERSION", "fegetround", "fesetround", "nextafter"};

TEST(Processors, NoLibraryCallsTheSystemsOwnTranscendentalFunctions) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "A build without sanitizers, whose own library wraps the functions of the system's.";
#endif
  ScratchFolder scratch;
  const auto ended =
      run_script("LD_BIND_NOW=1 LD_DEBUG=bindings LD_DEBUG_OUTPUT=bound unietp --version", scratch.path());
  ASSERT_EQ(ended.code, 0) << ended.err;
  std::set<std::string> of_libm, of_program;
  for (const auto& [name, text] : bytes_below(scratch.path())) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {  // ... binding file A [0] to B [0]: normal symbol `sin' [...]
      const auto to = line.find(" to "), open = line.find('`'), close = line.find('\'');
      if (to == std::string::npos || close == std::string::npos) continue;
      const auto file = line.substr(to + 4, line.find(' ', to + 4) - to - 4);
      const auto symbol = line.substr(open + 1, close - open - 1);
      if (file.find("/libm.so") != std::string::npos) of_libm.insert(symbol);
      if (file.ends_with("unietp")) of_program.insert(symbol);
    }
  }
  for (const auto& symbol : of_libm) EXPECT_TRUE(kExactInLibm.contains(symbol)) << symbol;
  // Bullet and FCL call these.
  for (const auto* symbol : {"sin", "cos", "sincos", "acos", "atan2", "pow"})
    EXPECT_TRUE(of_program.contains(symbol)) << symbol;
}

// With the C library's own functions, the first three homes differ between these two settings.
TEST(Processors, WithoutFusedMultiplyAddGiveTheSameHomesTasksAndPictures) {
  ScratchFolder scratch;
  const std::string make = R"(
    unietp scene make --layout behavior-benchmark-28,habitat-benchmark-12,virtualhome-benchmark-06 --out homes
    unietp generate --count 4 --seed 5 --rooms 5 --objects 60 --modes M1,M2,M3 --out tasks
    for task in ai2thor-00001 virtualhome-00002 habitat-00003 behavior-00004; do
      unietp render tasks $task --step 1 --out $task.png
    done)";
  const auto plain = run_script("mkdir plain && cd plain" + make, scratch.path());
  ASSERT_EQ(plain.code, 0) << plain.err;
  const auto other = run_script(
      "mkdir other && cd other && export GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2,-FMA,-AVX2_Usable,-FMA_Usable" + make,
      scratch.path());
  ASSERT_EQ(other.code, 0) << other.err;
  const auto bytes = bytes_below(scratch.path() / "plain"), others = bytes_below(scratch.path() / "other");
  EXPECT_THAT(bytes, ::testing::Contains(::testing::Key("behavior-00004.png")));
  ASSERT_EQ(bytes.size(), others.size());
  for (const auto& [name, content] : bytes) EXPECT_TRUE(others.at(name) == content) << name;
}

}  // namespace
}  // namespace unietp
