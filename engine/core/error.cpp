#include "core/error.hpp"

namespace pastoso::core {

InputError located_error(const std::string& file, long line, const std::string& message) {
    const std::string place = line > 0 ? file + ", line " + std::to_string(line) : file;
    return InputError(place + ": " + message);
}

}  // namespace pastoso::core
