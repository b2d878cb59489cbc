// A small file in which a part of the window remembers something between two starts.
#pragma once

#include "files/json_place.hpp"
#include "main/studio.hpp"

#include <filesystem>
#include <functional>

namespace pastoso::main {

class RememberedFile {
  public:
    using Work = std::function<void(const std::filesystem::path& file)>;

    /// An empty path where there is no home: nothing is written then. With `check`, which throws where
    /// the file is not well, only what has changed here is written over what other windows have written
    /// since it was read (tools/memory_merge.hpp); without, all of it.
    RememberedFile(Studio& studio, std::filesystem::path file, Work check = {});

    /// Has it read. Where `read` throws, the painter is told, and the file is left alone
    /// from then on.
    void recall(const Work& read);

    /// Has it written, if it may be. Where `write` throws, the painter is told.
    void remember(const Work& write);

  private:
    bool done(const Work& work);
    void put_together(const files::Json& mine, const files::Json& theirs);

    Studio& studio_;
    std::filesystem::path file_;
    Work check_;
    files::Json before_;  ///< as it was read, or written by this window alone
    bool usable_ = true;  ///< it is none that cannot be read
};

}  // namespace pastoso::main
