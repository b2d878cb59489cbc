// The only way in which a file is opened to be read: what is no regular file (a folder, a pipe, a
// device, a socket) is refused before anything waits for it or takes from it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>

namespace pastoso::core {

/// A regular file that is open for reading, closed at the end of its life.
class RegularFile {
  public:
    /// Throws InputError naming the path when it cannot be opened or is another kind of file. Returns at
    /// once, whatever stands at `path`.
    explicit RegularFile(const std::filesystem::path& path);
    ~RegularFile();
    RegularFile(const RegularFile&) = delete;
    RegularFile& operator=(const RegularFile&) = delete;

    /// Where the next read() begins is the same for all who use the descriptor or a copy of it.
    int descriptor() const { return descriptor_; }

    /// How many there were when it was opened.
    std::uint64_t bytes() const { return bytes_; }

    /// Puts `count` bytes from `place` on (0: the first) at `to`. Returns how many there were; fewer at
    /// the file's end. Throws InputError when the disk does not give them.
    std::size_t read_at(std::uint64_t place, void* to, std::size_t count) const;

    /// The same as text.
    std::string text_at(std::uint64_t place, std::size_t count) const;

  private:
    std::string name_;
    int descriptor_ = -1;
    std::uint64_t bytes_ = 0;
};

}  // namespace pastoso::core
