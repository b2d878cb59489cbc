#include "cli/interrupt.hpp"

#include <csignal>

namespace pastoso::cli {
namespace {

constexpr int kStopping[] = {SIGINT, SIGTERM, SIGHUP};

volatile std::sig_atomic_t signal_that_came = 0;

extern "C" void note_signal(int signal) {
    signal_that_came = signal;
}

bool is_ignored(int signal) {
    struct sigaction now {};
    sigaction(signal, nullptr, &now);
    return now.sa_handler == SIG_IGN;
}

}  // namespace

void outlive_failed_writes() {
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
}

void watch_for_interrupts() {
    struct sigaction action {};
    action.sa_handler = note_signal;
    action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
    for (const int signal : kStopping)
        if (!is_ignored(signal)) sigaction(signal, &action, nullptr);
}

bool is_interrupted() {
    return signal_that_came != 0;
}

void stop_if_interrupted() {
    if (is_interrupted()) throw Interrupted{};
}

int interrupted_status() {
    return 128 + signal_that_came;
}

}  // namespace pastoso::cli
