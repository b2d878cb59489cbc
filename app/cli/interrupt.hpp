// Ctrl-C: the work stops at the next tick, so that no file is left half-written.
#pragma once

namespace pastoso::cli {

/// Thrown by stop_if_interrupted().
struct Interrupted {};

/// From now on the first interrupt or termination signal is noted; a second one ends the program at
/// once.
void watch_for_interrupts();

/// Whether a signal has come.
bool is_interrupted();

/// Throws Interrupted when a signal has come.
void stop_if_interrupted();

}  // namespace pastoso::cli
