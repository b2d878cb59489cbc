// Ctrl-C, a terminal that is closed, a shutdown: the work stops at the next tick, so that no file is
// left half-written. A file that is being written then and takes a moment is finished first.
#pragma once

namespace pastoso::cli {

/// Thrown by stop_if_interrupted().
struct Interrupted {};

/// From now on, writing into a pipe that nobody reads and beyond the largest size of files fails with an
/// error, instead of ending the program.
void outlive_failed_writes();

/// From now on the first SIGINT, SIGTERM or SIGHUP is noted; a second one of its kind ends the program
/// at once. One that is ignored already, as SIGHUP is under nohup, stays so.
void watch_for_interrupts();

/// Whether a signal has come.
bool is_interrupted();

/// Throws Interrupted when a signal has come.
void stop_if_interrupted();

/// What the program ends with when a signal has come: 128 and the signal's number, as shells have it.
int interrupted_status();

}  // namespace pastoso::cli
