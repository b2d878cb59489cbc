#include "source_file.hpp"

namespace pastoso::tests {

std::string source_file(const std::string& path) {
    return PASTOSO_SOURCE_DIR "/" + path;
}

}  // namespace pastoso::tests
