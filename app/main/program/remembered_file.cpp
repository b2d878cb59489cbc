#include "main/program/remembered_file.hpp"

#include <utility>

namespace pastoso::main {

RememberedFile::RememberedFile(Studio& studio, std::filesystem::path file)
    : studio_(studio), file_(std::move(file)) {}

void RememberedFile::recall(const Work& read) {
    usable_ = done(read);
}

void RememberedFile::remember(const Work& write) {
    if (usable_ && !file_.empty()) done(write);
}

/// False: it was not, and the painter knows.
bool RememberedFile::done(const Work& work) {
    return studio_.attempt([&] { work(file_); });
}

}  // namespace pastoso::main
