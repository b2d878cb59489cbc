// How fine a canvas this machine keeps pace with, measured once.
#pragma once

namespace pastoso::main {

/// The finest cells on which it paints as fast as the hand moves (session/live_speed.hpp); 4 where that
/// cannot be measured. Measured in some tenths of a second at the first start, and when the number of
/// processors is another; kept in machine.json. Where that cannot be read or written it is measured at
/// every start.
double live_px_per_mm();

}  // namespace pastoso::main
