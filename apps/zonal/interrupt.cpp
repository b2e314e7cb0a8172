#include "apps/zonal/interrupt.h"

#include <csignal>
#include <thread>

namespace zonal {

std::stop_token stop_on_interrupt() {
  // A signal handler may do next to nothing; a thread that waits for the signal may do anything. All other threads
  // inherit the block.
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);

  std::stop_source source;
  std::thread([signals, source]() mutable {
    int received = 0;
    while (sigwait(&signals, &received) == 0) source.request_stop();
  }).detach();  // it ends with the process
  return source.get_token();
}

}  // namespace zonal
