// Numbers as text, for people and for files.
#pragma once

#include <cstdint>
#include <string>

namespace pastoso::core {

/// The shortest decimal text that reads back as the same number: "0.1", "1e+30", "nan".
std::string number_text(double value);

/// The same with so many significant digits at most (1 to 17), as printf("%.9g") writes it in the C
/// locale.
std::string number_text(double value, int digits);

/// Sixteen hexadecimal digits.
std::string hex_text(std::uint64_t value);

}  // namespace pastoso::core
