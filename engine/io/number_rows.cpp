#include "io/number_rows.hpp"

#include "document/number_text.hpp"

#include <cmath>

namespace pastoso::io {

void append_numbers(std::string& text, std::initializer_list<double> numbers) {
    for (const double number : numbers) {
        if (!text.empty() && text.back() != '\n') text += ',';
        text += std::isnan(number) ? "nan" : document::number_text(number);
    }
}

}  // namespace pastoso::io
