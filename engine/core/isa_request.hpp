// Whether the environment asks for an instruction set that there is.
#pragma once

namespace pastoso::core {

/// Throws InputError where PASTOSO_ISA (isa.hpp) is set to a name that is none. For a program, at its
/// start: best_isa() takes no notice of such a name.
void check_isa_request();

}  // namespace pastoso::core
