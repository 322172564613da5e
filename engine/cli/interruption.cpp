#include "interruption.hpp"

#include <atomic>
#include <csignal>

namespace rgimp::cli {

namespace {

constexpr int kSignals[] = {SIGINT, SIGTERM, SIGHUP, SIGPIPE};

// 0: none yet. A handler can reach nothing but a global; threads of a sweep read it meanwhile,
// which std::sig_atomic_t is not made for.
std::atomic<int> g_signal = 0;
static_assert(std::atomic<int>::is_always_lock_free, "a lock would not do in a handler");

void note(int signal) {
  g_signal = signal;
  std::signal(signal, SIG_DFL);
}

}  // namespace

Interruption::Interruption() {
  g_signal = 0;
  std::signal(SIGXFSZ, SIG_IGN);
  for (const int signal : kSignals) {
    if (std::signal(signal, note) == SIG_IGN) {
      std::signal(signal, SIG_IGN);  // nohup and background jobs are not meant to be interrupted
    }
  }
}

Interruption::~Interruption() {
  std::signal(SIGXFSZ, SIG_DFL);
  for (const int signal : kSignals) {
    std::signal(signal, SIG_DFL);
  }
}

std::optional<int> Interruption::signal() const {
  const int signal = g_signal;
  return signal == 0 ? std::nullopt : std::optional<int>(signal);
}

}  // namespace rgimp::cli
