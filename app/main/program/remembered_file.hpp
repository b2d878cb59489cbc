// A small file in which a part of the window remembers something between two starts.
#pragma once

#include "main/studio.hpp"

#include <filesystem>
#include <functional>

namespace pastoso::main {

class RememberedFile {
  public:
    using Work = std::function<void(const std::filesystem::path& file)>;

    /// An empty path where there is no home: nothing is written then.
    RememberedFile(Studio& studio, std::filesystem::path file);

    /// Has it read. Where `read` throws, the painter is told, and the file is left alone
    /// from then on.
    void recall(const Work& read);

    /// Has it written, if it may be. Where `write` throws, the painter is told.
    void remember(const Work& write);

  private:
    bool done(const Work& work);

    Studio& studio_;
    std::filesystem::path file_;
    bool usable_ = true;  ///< it is none that cannot be read
};

}  // namespace pastoso::main
