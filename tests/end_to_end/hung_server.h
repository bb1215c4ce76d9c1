#pragma once

#include <chrono>
#include <functional>
#include <thread>

#include <gtest/gtest.h>

#include "program.h"

namespace unietp {

/// Waits until `hangs` says that a server keeps the program waiting, at most a minute, then interrupts it: it ends
/// within two seconds.
inline void expect_end_while_server_hangs(RunningProgram& program, int signal, const std::function<bool()>& hangs) {
  const auto latest = std::chrono::steady_clock::now() + std::chrono::minutes(1);
  while (program.running() && !hangs() && std::chrono::steady_clock::now() < latest) std::this_thread::yield();
  EXPECT_TRUE(program.running() && hangs());
  program.send(signal);
  const auto sent = std::chrono::steady_clock::now();
  const auto ended = program.wait();
  EXPECT_LT(std::chrono::steady_clock::now() - sent, std::chrono::seconds(2));
  EXPECT_EQ(ended.code, 130) << ended.out << ended.err;
}

}  // namespace unietp
