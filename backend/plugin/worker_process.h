// SPDX-License-Identifier: BSD-3-Clause
// The process of a back end, seen from the program.
#ifndef GMAPPING_SPA_BACKEND_PLUGIN_WORKER_PROCESS_H_
#define GMAPPING_SPA_BACKEND_PLUGIN_WORKER_PROCESS_H_

#include <sys/types.h>

#include <memory>
#include <string>

#include "backend/plugin/packet_channel.h"

namespace gmapping_spa::backend {

class WorkerProcess {
 public:
  // Starts the executable `worker` with the path of the plugin and the number of the file
  // descriptor of its channel. SIGINT and SIGTERM, which a terminal or a scheduler sends to all
  // processes of a program, are the program's affair: the worker does not get them. Throws
  // std::runtime_error with one line when it cannot be started.
  WorkerProcess(const std::string& worker, const std::string& plugin);
  // Lets the back end end, and kills it after a second.
  ~WorkerProcess();
  WorkerProcess(const WorkerProcess&) = delete;
  WorkerProcess& operator=(const WorkerProcess&) = delete;

  const PacketChannel& channel() const { return *channel_; }

  // Ends it at once.
  void Kill();

  // How it has ended, or ends within a second: "crashed with signal 11 (Segmentation fault)",
  // "exited with status 3". Else kills it: "closed its channel".
  std::string End();

 private:
  // Whether it ends within that time; waits for it no more afterwards.
  bool EndsWithin(double time_s);

  pid_t process_ = -1;
  int status_ = 0;
  std::unique_ptr<PacketChannel> channel_;
};

}  // namespace gmapping_spa::backend

#endif  // GMAPPING_SPA_BACKEND_PLUGIN_WORKER_PROCESS_H_
