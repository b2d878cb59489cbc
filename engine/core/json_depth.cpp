#include "core/json_depth.hpp"

#include "core/error.hpp"

namespace pastoso::core {
namespace {

bool nests_too_deep(std::string_view text) {
    int depth = 0;
    bool in_string = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char letter = text[i];
        if (in_string) {
            if (letter == '\\') ++i;
            in_string = letter != '"';
            continue;
        }
        in_string = letter == '"';
        if (letter == '[' || letter == '{') ++depth;
        if (letter == ']' || letter == '}') --depth;
        if (depth > kDeepestJson) return true;
    }
    return false;
}

}  // namespace

void check_json_depth(std::string_view text, const std::string& file) {
    if (!nests_too_deep(text)) return;
    throw InputError("%1: lists and objects are nested more than %2 deep.", file, kDeepestJson);
}

}  // namespace pastoso::core
