#include "interruption.hpp"

#include <csignal>

namespace rgimp::cli {

namespace {

constexpr int kSignals[] = {SIGINT, SIGTERM, SIGHUP, SIGPIPE};

volatile std::sig_atomic_t g_signal = 0;  // 0: none yet; a handler can reach nothing else

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
  return g_signal == 0 ? std::nullopt : std::optional<int>(g_signal);
}

}  // namespace rgimp::cli
