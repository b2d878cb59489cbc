#include "core/error.hpp"

namespace pastoso::core {

InputError located_error(const std::string& file, long line, const Message& message) {
    if (line > 0) return InputError("%1, line %2: %3", file, line, message);
    return InputError("%1: %2", file, message);
}

}  // namespace pastoso::core
