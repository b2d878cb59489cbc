// Lines of numbers in tables of comma-separated values.
#pragma once

#include <initializer_list>
#include <string>

namespace pastoso::files {

/// Adds numbers to the line that the text ends in, each the shortest that reads back the same; "nan"
/// stands where there is none.
void append_numbers(std::string& text, std::initializer_list<double> numbers);

}  // namespace pastoso::files
