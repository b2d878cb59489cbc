// A large file that is written in pieces, aside, and can be stopped.
#pragma once

#include "core/output_file.hpp"
#include "files/keep_going.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace pastoso::files {

class PieceWriter {
  public:
    template <class Value>
    void add(const Value& value) {
        buffer_.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
    void add_text(std::string_view text) { buffer_ += text; }

    /// After every item, which is small; a piece is written when there is enough of it. Throws what only
    /// write_in_pieces() catches when it is to stop.
    void item_done();

  private:
    friend ExportStatus write_in_pieces(const std::filesystem::path& path, std::size_t items,
                                        const KeepGoing& keep_going,
                                        const std::function<void(PieceWriter&)>& write);
    struct Stopped {};

    PieceWriter(core::OutputFile& file, std::size_t items, const KeepGoing& keep_going)
        : file_(file), items_(items), keep_going_(keep_going) {}
    void flush();

    core::OutputFile& file_;
    std::string buffer_;
    std::size_t items_, done_ = 0;
    const KeepGoing& keep_going_;
};

/// Calls write(writer), which calls item_done() `items` times, and moves the file into place. Throws
/// InputError when it cannot be written; `path` is then as it was, as it is when the work was stopped.
ExportStatus write_in_pieces(const std::filesystem::path& path, std::size_t items,
                             const KeepGoing& keep_going,
                             const std::function<void(PieceWriter&)>& write);

}  // namespace pastoso::files
