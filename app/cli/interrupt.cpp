#include "cli/interrupt.hpp"

#include <csignal>

namespace pastoso::cli {
namespace {

volatile std::sig_atomic_t signal_came = 0;

extern "C" void note_signal(int) {
    signal_came = 1;
}

}  // namespace

void watch_for_interrupts() {
    struct sigaction action {};
    action.sa_handler = note_signal;
    action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
}

bool is_interrupted() {
    return signal_came != 0;
}

void stop_if_interrupted() {
    if (is_interrupted()) throw Interrupted{};
}

}  // namespace pastoso::cli
