// Prints the table of actions for docs/stroke-format.md or, with --dictionary, tests/fuzz/strokes.dict.
#include "recordings/action_table.hpp"

#include <cstdio>
#include <cstring>

int main(int count, char** arguments) {
    const bool dictionary = count > 1 && std::strcmp(arguments[1], "--dictionary") == 0;
    std::fputs(
        (dictionary ? pastoso::recordings::action_dictionary() : pastoso::recordings::action_table())
            .c_str(),
        stdout);
    return 0;
}
