#include "files/number_rows.hpp"

#include "core/number_text.hpp"

#include <cmath>

namespace pastoso::files {

void append_numbers(std::string& text, std::initializer_list<double> numbers) {
    for (const double number : numbers) {
        if (!text.empty() && text.back() != '\n') text += ',';
        text += std::isnan(number) ? "nan" : core::number_text(number);
    }
}

}  // namespace pastoso::files
