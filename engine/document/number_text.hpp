// Numbers in sentences for people.
#pragma once

#include <string>

namespace pastoso::document {

/// The shortest decimal text that reads back as the same number: "0.1", "1e+30", "nan".
std::string number_text(double value);

}  // namespace pastoso::document
