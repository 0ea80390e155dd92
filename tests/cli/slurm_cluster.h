// A Slurm cluster of two nodes on this machine, in a folder of its own: munge, a controller and two
// daemons, which end with the object.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <netinet/in.h>
#include <pwd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <stdexcept>

#include "tests/cli/program.h"
#include "tests/cli/racebeam_processes.h"

namespace racebeam {

class SlurmCluster {
 public:
  /// What is not installed; "": all is.
  static std::string missing() {
    for (const char* tool : {"munged", "mungekey", "slurmctld", "slurmd", "sbatch", "squeue"})
      if (run(std::string("command -v ") + tool).empty())
        return std::string(tool) + " is not installed; see scripts/setup long";
    return "";
  }

  SlurmCluster() {
    // munge wants its socket to be reached by all.
    std::filesystem::permissions(folder_.path(), std::filesystem::perms(0711));
    setenv("SLURM_CONF", (folder_ / "slurm.conf").c_str(), 1);
    write_settings();
    run("mungekey --create --keyfile=" + folder_ / "munge.key");
    run("munged --key-file=" + folder_ / "munge.key" + " --socket=" + folder_ / "munge.socket" +
        " --pid-file=" + folder_ / "munged.pid" + " --log-file=" + folder_ / "munged.log" +
        " --seed-file=" + folder_ / "munged.seed");
    start_controller();
    for (const char* node : {"n1", "n2"}) start_node(node);
    if (within(60, [] { return run("timeout 5 sinfo -h -t idle -o %D") == "2\n"; })) return;
    const std::string why =
        read_file(folder_ / "munged.log") + read_file(folder_ / "slurmctld.log");
    stop();
    throw std::runtime_error("the cluster does not start:\n" + why);
  }
  ~SlurmCluster() { stop(); }

  static void start_controller() { run("slurmctld"); }
  static void start_node(const std::string& node) { run("slurmd -N " + node); }
  /// As a machine that loses power: the daemon, the keepers of its tasks, and the tasks.
  void kill_node(const std::string& node) const {
    std::set<int> all = {daemon("slurmd." + node)};
    for (const int task : own_.with("environ", "SLURMD_NODENAME=" + node)) {
      all.insert(task);
      std::istringstream words(read_file("/proc/" + std::to_string(task) + "/status"));
      int parent = 0;
      for (std::string word; words >> word;)
        if (word == "PPid:") words >> parent;
      if (read_file("/proc/" + std::to_string(parent) + "/comm") == "slurmstepd\n")
        all.insert(parent);
    }
    for (const int process : all) kill(process, SIGKILL);
  }
  void kill_controller() const { kill(daemon("slurmctld"), SIGKILL); }

  /// Ends it; the number of processes that are left then.
  int stop() {
    run("timeout 20 scancel --user=$(id -un)");
    within(20, [] { return run("timeout 10 squeue -h").empty(); });
    for (const char* name : {"slurmd.n1", "slurmd.n2", "slurmctld", "munged"}) {
      const int process = daemon(name);
      if (process <= 0 || kill(process, SIGTERM) != 0) continue;
      if (!within(20, [process] { return kill(process, 0) != 0; })) kill(process, SIGKILL);
    }
    within(10, [this] { return own_.count() == 0; });
    const std::vector<int> left = own_.with("", "");
    for (const int process : left) kill(process, SIGKILL);
    return static_cast<int>(left.size());
  }

  /// What a command says.
  static std::string run(const std::string& command) {
    const std::string with_path = "PATH=$PATH:/usr/sbin:/sbin; " + command + " 2>&1";
    std::FILE* const pipe = popen(with_path.c_str(), "r");
    std::string said;
    for (int c; pipe && (c = std::fgetc(pipe)) != EOF;) said += static_cast<char>(c);
    if (pipe) pclose(pipe);
    return said;
  }
  template <class Condition>
  static bool within(int seconds, Condition condition) {
    using Clock = std::chrono::steady_clock;
    for (const auto end = Clock::now() + std::chrono::seconds(seconds); !condition();
         usleep(100'000))
      if (Clock::now() > end) return false;
    return true;
  }

 private:
  int daemon(const std::string& name) const {
    return std::atoi(read_file(folder_ / (name + ".pid")).c_str());
  }

  /// Ports that nobody listens on.
  static std::array<int, 3> free_ports() {
    std::array<int, 3> ports{}, sockets{};
    for (std::size_t i = 0; i < ports.size(); ++i) {
      sockaddr_in address{};
      address.sin_family = AF_INET;
      address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
      socklen_t size = sizeof address;
      sockets[i] = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
      bind(sockets[i], reinterpret_cast<sockaddr*>(&address), size);
      getsockname(sockets[i], reinterpret_cast<sockaddr*>(&address), &size);
      ports[i] = ntohs(address.sin_port);
    }
    for (const int socket : sockets) close(socket);
    return ports;
  }

  void write_settings() const {
    char host[256] = "";
    gethostname(host, sizeof host - 1);
    const std::string name = std::string(host).substr(0, std::string(host).find('.'));
    const std::string user = getpwuid(getuid())->pw_name;
    const std::array<int, 3> ports = free_ports();
    std::filesystem::create_directory(folder_ / "state");
    for (const char* node : {"n1", "n2"})
      std::filesystem::create_directory(folder_ / (std::string("spool.") + node));
    std::ofstream out(folder_ / "slurm.conf");
    out << "ClusterName=test\nSlurmctldHost=" << name << "(127.0.0.1)\n"
        << "SlurmctldPort=" << ports[0] << "\nSlurmUser=" << user << "\nSlurmdUser=" << user
        << "\nAuthType=auth/munge\nCredType=cred/munge\nAuthInfo=socket="
        << folder_ / "munge.socket"
        << "\nStateSaveLocation=" << folder_ / "state"
        << "\nSlurmdSpoolDir=" << folder_ / "spool.%n"
        << "\nSlurmctldPidFile=" << folder_ / "slurmctld.pid"
        << "\nSlurmdPidFile=" << folder_ / "slurmd.%n.pid"
        << "\nSlurmctldLogFile=" << folder_ / "slurmctld.log"
        << "\nSlurmdLogFile=" << folder_ / "slurmd.%n.log"
        << "\nProctrackType=proctrack/linuxproc\nTaskPlugin=task/none\nMpiDefault=none\n"
           "JobAcctGatherType=jobacct_gather/none\nSwitchType=switch/none\n"
           "SelectType=select/cons_tres\nSelectTypeParameters=CR_CPU\n"
           "ReturnToService=2\nSlurmdTimeout=10\nMailProg=/bin/true\n";
    for (const int node : {1, 2})
      out << "NodeName=n" << node << " NodeHostname=" << name
          << " NodeAddr=127.0.0.1 CPUs=1 Port=" << ports[static_cast<std::size_t>(node)] << "\n";
    out << "PartitionName=all Nodes=n1,n2 Default=YES MaxTime=INFINITE State=UP\n";
  }

  ScratchFolder folder_;
  const MarkedProcesses own_{"SLURM_CONF=" + folder_.path()};
};

}  // namespace racebeam
