// Zip archives by libzip: written in one go, read entry by entry.
#pragma once

#include "core/message.hpp"
#include "core/output_file.hpp"
#include "core/progress.hpp"
#include "packing/packed_bytes.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace pastoso::project {

using packing::Bytes;

/// The entries of an archive to be, in their order. Nothing is compressed: what is large is packed
/// already. The same entries give the same archive.
class ZipWriter {
  public:
    void add(std::string name, Bytes content);
    void add(std::string name, const std::string& content);

    /// An entry whose content is made while those before it are written.
    void add(std::string name, std::future<Bytes> content);

    /// An entry whose content is made when its turn comes.
    void add(std::string name, std::function<std::string()> make);

    /// Writes the archive into `file` and forgets every entry as soon as it is written; once. Throws InputError
    /// when that fails, and what the making of a content threw.
    void write(core::OutputFile& file);

  private:
    struct Entry {
        std::string name;
        std::future<Bytes> content;
    };
    std::vector<Entry> entries_;
};

/// Tells how much of the file has been read. Never writes anywhere; the names in an archive are compared
/// and not used as paths. May be used by several threads, one of which reads at a time.
class ZipReader {
  public:
    /// Throws InputError when the file cannot be opened or is no zip archive.
    explicit ZipReader(const std::filesystem::path& path, core::Progress progress = {});
    /// The same of an archive in memory, which outlives the reader.
    ZipReader(std::span<const std::byte> archive, std::string name);
    ~ZipReader();

    const std::string& name() const { return name_; }

    bool has(const std::string& entry) const;

    /// Content of an entry; more than `most_bytes` are not read, whatever its header says. Throws
    /// InputError "NAME, ENTRY: ..." when it is missing, larger or damaged.
    Bytes read(const std::string& entry, std::size_t most_bytes) const;

    [[noreturn]] void fail(const std::string& entry, const core::Message& sentence) const;
    template <class... Arguments>
    [[noreturn]] void fail(const std::string& entry, core::Pattern<sizeof...(Arguments)> pattern,
                           const Arguments&... arguments) const {
        fail(entry, core::message(pattern, arguments...));
    }

  private:
    struct Archive;
    void tell() const;

    std::string name_;
    std::unique_ptr<Archive> archive_;
    core::Progress progress_;
    mutable std::mutex mutex_;
    mutable std::size_t read_bytes_ = 0;
    std::size_t file_bytes_ = 0;
};

}  // namespace pastoso::project
