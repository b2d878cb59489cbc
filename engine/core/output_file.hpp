// The one way in which the programs write files: aside, and then in the place of the old one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace pastoso::core {

/// Which file may lose its place to the one in the making: one that this user may write, any, or none.
enum class Replaced { Writable, Any, None };

/// A file in the making. Its bytes go into a part file beside the one that it replaces, which stays as it was until
/// put_in_place(): readers see the old file or the whole new one, after a power cut too. The new one has the
/// permissions of the old one, and its owner where the system allows that.
class OutputFile {
  public:
    /// Where `path` is a symbolic link, what it leads to is replaced. Throws InputError when the folder
    /// does not exist or is not writable, when `path` is a folder, a device, a pipe or a socket, and
    /// when a file stands there that may not be replaced.
    explicit OutputFile(std::filesystem::path path, Replaced = Replaced::Writable);
    /// Removes the part file, unless that has been put in place.
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    /// The name that was asked for, which stands in errors.
    const std::filesystem::path& path() const { return path_; }

    /// For programs that write a file by its name; it has the extension of `path`.
    const std::filesystem::path& part() const { return part_; }

    /// Writes behind the last byte, or at a place in bytes; small pieces wait for others. A failure is kept and told by
    /// check(): format libraries that write through these may end the program when they hear of one.
    void append(std::span<const std::byte> bytes) noexcept { write_at(end_, bytes); }
    void append(std::string_view text) noexcept { append(std::as_bytes(std::span(text))); }
    void write_at(std::uint64_t place, std::span<const std::byte> bytes) noexcept;

    /// Bytes up to the last that was written.
    std::uint64_t size() const { return end_; }

    /// Throws InputError with the system's reason when anything could not be written so far.
    void check() const;

    /// Flushes the part file to the disk, gives it the place of the old file and flushes the folder.
    /// Throws InputError when any of that fails; the old file is then as it was, unless the folder alone
    /// could not be flushed. Where nothing may be replaced, a file that has come to stand there
    /// meanwhile stays.
    void put_in_place();

  private:
    void create_part();
    void take_over_rights();
    void write_waiting() noexcept;
    void write_now(std::uint64_t place, std::span<const std::byte> bytes) noexcept;
    [[noreturn]] void refuse(int reason) const;
    void flush_folder() const;

    bool take_place() const;

    std::filesystem::path path_;
    Replaced replaced_;
    std::filesystem::path target_;  ///< what is replaced: `path_` with its links followed
    std::filesystem::path part_;
    std::string waiting_;          ///< bytes to be written together, at `waiting_place_`
    std::uint64_t waiting_place_ = 0;
    std::uint64_t end_ = 0;
    int file_ = -1;
    int reason_ = 0;  ///< of the first failure, as the system numbers them
};

/// Whether a file stands at `path` that OutputFile refuses as write-protected.
bool is_write_protected(const std::filesystem::path& path);

/// Lets `write` fill an OutputFile and puts it in place. If `write` throws, `path` is as it was.
void write_aside(const std::filesystem::path& path, const std::function<void(OutputFile& file)>& write,
                 Replaced = Replaced::Writable);

/// The same, but `write` may give up: where it returns false, `path` is as it was, and false is returned.
bool write_aside_unless(const std::filesystem::path& path,
                        const std::function<bool(OutputFile& file)>& write);

}  // namespace pastoso::core
