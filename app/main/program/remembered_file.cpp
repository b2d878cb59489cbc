#include "main/program/remembered_file.hpp"

#include "core/error.hpp"
#include "tools/memory_file.hpp"
#include "tools/memory_merge.hpp"

#include <utility>

namespace pastoso::main {

RememberedFile::RememberedFile(Studio& studio, std::filesystem::path file, Work check)
    : studio_(studio), file_(std::move(file)), check_(std::move(check)) {}

void RememberedFile::recall(const Work& read) {
    usable_ = done(read);
    if (check_) before_ = tools::memory_in(file_);
}

void RememberedFile::remember(const Work& write) {
    if (!usable_ || file_.empty()) return;
    const files::Json theirs = check_ ? tools::memory_in(file_) : files::Json();
    if (!done(write) || !check_) return;
    const files::Json mine = tools::memory_in(file_);
    if (!theirs.is_null()) put_together(mine, theirs);
    before_ = mine;
}

/// Where both do not go together, mine stays.
void RememberedFile::put_together(const files::Json& mine, const files::Json& theirs) {
    const files::Json both = tools::merged(before_, mine, theirs);
    if (both == mine) return;
    try {
        tools::write_memory(both, file_);
        check_(file_);
    } catch (const core::InputError&) {
        done([&](const auto& file) { tools::write_memory(mine, file); });
    }
}

/// False: it was not, and the painter knows.
bool RememberedFile::done(const Work& work) {
    return studio_.attempt([&] { work(file_); });
}

}  // namespace pastoso::main
