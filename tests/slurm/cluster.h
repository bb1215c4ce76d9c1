#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tests/end_to_end/program.h"

namespace unietp::testing {

/// A Slurm cluster of one node on loopback, with keys, ports, state and logs of its own: munged, slurmctld and slurmd
/// as children of this process. It ends with this value, and all its daemons with it.
class SlurmCluster {
 public:
  SlurmCluster();
  SlurmCluster(const SlurmCluster&) = delete;
  SlurmCluster& operator=(const SlurmCluster&) = delete;
  ~SlurmCluster();

  /// Why it does not run here; "" when it does.
  const std::string& why_not() const { return why_not_; }
  /// Lines for a shell that let Slurm's commands find this cluster.
  std::string environment() const;

 private:
  struct Daemon {
    pid_t process = -1;
    int output = -1;
  };
  void start();
  bool write_settings();
  /// Starts a daemon that stays in the foreground and waits until its output has the words.
  bool start_daemon(const std::vector<std::string>& command, const std::string& words);
  bool wait_for(int output, const std::string& words, std::string& told) const;

  ScratchFolder folder_;
  std::vector<Daemon> daemons_;
  std::string why_not_;
};

}  // namespace unietp::testing
