#include "main/program/remembered_file.hpp"

#include "core/error.hpp"

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
    try {
        work(file_);
        return true;
    } catch (const core::InputError& error) {
        studio_.report(QString::fromUtf8(error.what()));
        return false;
    }
}

}  // namespace pastoso::main
