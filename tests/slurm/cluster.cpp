#include "cluster.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>

#include "core/files.h"
#include "core/text.h"

namespace unietp::testing {
namespace {

namespace fs = std::filesystem;

constexpr int kPatience_ms = 20000;

/// Where a daemon lies; "" when it is not installed.
std::string installed(const std::string& name) {
  for (const char* folder : {"/usr/sbin/", "/usr/bin/", "/usr/local/sbin/", "/usr/local/bin/"}) {
    if (access((folder + name).c_str(), X_OK) == 0) return folder + name;
  }
  return "";
}

/// A port of loopback that nobody listens on.
int free_port() {
  const int socket = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t length = sizeof address;
  int port = 0;
  if (bind(socket, reinterpret_cast<const sockaddr*>(&address), length) == 0 &&
      getsockname(socket, reinterpret_cast<sockaddr*>(&address), &length) == 0)
    port = ntohs(address.sin_port);
  close(socket);
  return port;
}

std::string host_name() {
  char name[256] = {};
  return gethostname(name, sizeof name - 1) == 0 ? name : "";
}

}  // namespace

SlurmCluster::SlurmCluster() {
  for (const char* name : {"munged", "slurmctld", "slurmd", "sbatch"}) {
    if (installed(name).empty()) {
      why_not_ = std::string(name) + " is not installed (Debian: slurm-wlm and munge)";
      return;
    }
  }
  if (geteuid() != 0) {
    why_not_ = "slurmd starts jobs for others only as root";
    return;
  }
  start();
}

SlurmCluster::~SlurmCluster() {
  for (auto daemon = daemons_.rbegin(); daemon != daemons_.rend(); ++daemon) {
    kill(daemon->process, SIGTERM);
    waitpid(daemon->process, nullptr, 0);
    close(daemon->output);
  }
}

std::string SlurmCluster::environment() const { return "export SLURM_CONF=" + folder_.at("slurm.conf") + "\n"; }

void SlurmCluster::start() {
  if (!write_settings()) {
    why_not_ = "its settings cannot be written";
    return;
  }
  const std::string host = host_name(), settings = folder_.at("slurm.conf");
  if (!start_daemon({installed("munged"), "--foreground", "--force", "--key-file=" + folder_.at("munge.key"),
                     "--socket=" + folder_.at("munge.socket"), "--pid-file=" + folder_.at("munged.pid"),
                     "--seed-file=" + folder_.at("munged.seed")},
                    "Created socket"))
    return;
  if (!start_daemon({installed("slurmctld"), "-D", "-f", settings}, "Running as primary controller")) return;
  start_daemon({installed("slurmd"), "-D", "-N", host, "-f", settings}, "slurmd started on");
}

bool SlurmCluster::write_settings() {
  const std::string host = host_name();
  std::string key(128, '\0');
  for (std::size_t i = 0; i < key.size(); ++i) key[i] = static_cast<char>(37 * i + getpid());  // only we use it
  const std::string settings = "ClusterName=unietp\nSlurmctldHost=" + host +
                               "(127.0.0.1)\nSlurmctldPort=" + std::to_string(free_port()) +
                               "\nSlurmdPort=" + std::to_string(free_port()) +
                               "\nAuthType=auth/munge\nAuthInfo=socket=" + folder_.at("munge.socket") +
                               "\nSlurmUser=root\nSlurmdUser=root\nProctrackType=proctrack/linuxproc\n"
                               "TaskPlugin=task/none\nMpiDefault=none\nSelectType=select/cons_tres\n"
                               "SelectTypeParameters=CR_Core\nReturnToService=2\nMailProg=/bin/true\n"
                               "SchedulerParameters=sched_interval=1\nStateSaveLocation=" +
                               folder_.at("state") + "\nSlurmdSpoolDir=" + folder_.at("spool") +
                               "\nSlurmctldPidFile=" + folder_.at("slurmctld.pid") +
                               "\nSlurmdPidFile=" + folder_.at("slurmd.pid") + "\nNodeName=" + host +
                               " NodeAddr=127.0.0.1 CPUs=2 RealMemory=1000\n"
                               "PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP\n";
  std::error_code code;
  fs::create_directories(folder_.at("state"), code);
  fs::create_directories(folder_.at("spool"), code);
  if (!write_file(folder_.at("munge.key"), key) || !write_file(folder_.at("slurm.conf"), settings)) return false;
  fs::permissions(folder_.at("munge.key"), fs::perms::owner_read | fs::perms::owner_write, code);
  return !code;
}

bool SlurmCluster::start_daemon(const std::vector<std::string>& command, const std::string& words) {
  int ends[2] = {};
  if (pipe2(ends, O_CLOEXEC) != 0) return false;
  const pid_t process = fork();
  if (process == 0) {
    dup2(ends[1], STDOUT_FILENO);
    dup2(ends[1], STDERR_FILENO);
    std::vector<char*> words_of_command;
    for (const auto& word : command) words_of_command.push_back(const_cast<char*>(word.c_str()));
    words_of_command.push_back(nullptr);
    execv(words_of_command[0], words_of_command.data());
    _exit(127);
  }
  close(ends[1]);
  daemons_.push_back({process, ends[0]});
  std::string told;
  if (wait_for(ends[0], words, told)) return true;
  why_not_ = command[0] + " does not start: " + told;
  return false;
}

bool SlurmCluster::wait_for(int output, const std::string& words, std::string& told) const {
  const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(kPatience_ms);
  while (told.find(words) == std::string::npos) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - std::chrono::steady_clock::now());
    pollfd readable{output, POLLIN, 0};
    if (left.count() <= 0 || poll(&readable, 1, static_cast<int>(left.count())) <= 0) return false;
    char bytes[4096];
    const auto count = read(output, bytes, sizeof bytes);
    if (count <= 0) return false;
    told.append(bytes, static_cast<std::size_t>(count));
  }
  return true;
}

}  // namespace unietp::testing
