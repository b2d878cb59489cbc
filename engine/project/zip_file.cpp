#include "project/zip_file.hpp"

#include "core/error.hpp"
#include "core/regular_file.hpp"
#include "project/zip_destination.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <deque>
#include <exception>
#include <fcntl.h>
#include <unistd.h>
#include <utility>
#include <zip.h>

namespace pastoso::project {
namespace {

/// 1 January 1980, the first that zip archives know: the same painting gives the same file.
constexpr zip_uint16_t kDosDate = (1 << 5) | 1;

std::string text_of(zip_error_t* error) {
    // libzip takes the number of the system's error along only in zip_error_t.
    if (zip_error_system_type(error) == ZIP_ET_SYS && zip_error_code_system(error) != 0)
        return std::strerror(zip_error_code_system(error));
    return zip_error_strerror(error);
}

struct Discard {
    void operator()(zip_t* archive) const { zip_discard(archive); }
};
using Archive = std::unique_ptr<zip_t, Discard>;

struct CloseFile {
    void operator()(zip_file_t* file) const { zip_fclose(file); }
};

[[noreturn]] void fail_writing(const std::string& name, zip_error_t* error) {
    throw core::InputError("%1: cannot be written (%2).", name, text_of(error));
}

Archive create(ZipDestination& destination, const std::string& name) {
    zip_error_t error;
    zip_error_init(&error);
    zip_source_t* source = destination.source(&error);
    Archive archive(source == nullptr ? nullptr
                                      : zip_open_from_source(source, ZIP_CREATE | ZIP_TRUNCATE, &error));
    if (archive) return archive;
    zip_source_free(source);
    fail_writing(name, &error);
}

Bytes copied(const std::string& text) {
    const auto bytes = packing::bytes_of(text);
    return {bytes.begin(), bytes.end()};
}

/// The content of an entry as libzip asks for it: first its size, then all of it once.
class Content {
  public:
    explicit Content(std::future<Bytes> coming) : coming_(std::move(coming)) { zip_error_init(&error_); }

    void rethrow() const {
        if (fault_) std::rethrow_exception(fault_);
    }

    static zip_int64_t answer(void* content, void* data, zip_uint64_t size, zip_source_cmd_t question) {
        return static_cast<Content*>(content)->answer(data, size, question);
    }

  private:
    zip_int64_t answer(void* data, zip_uint64_t size, zip_source_cmd_t question) {
        switch (question) {
            case ZIP_SOURCE_OPEN:
                return 0;
            case ZIP_SOURCE_READ:
                return read(data, size);
            case ZIP_SOURCE_CLOSE:
                bytes_ = {};
                return 0;
            case ZIP_SOURCE_STAT:
                return describe(data);
            case ZIP_SOURCE_ERROR:
                return zip_error_to_data(&error_, data, size);
            case ZIP_SOURCE_FREE:
                return 0;
            case ZIP_SOURCE_SUPPORTS:
                return ZIP_SOURCE_SUPPORTS_READABLE;
            default:
                zip_error_set(&error_, ZIP_ER_OPNOTSUPP, 0);
                return -1;
        }
    }

    /// libzip is C: nothing may be thrown through it.
    bool arrived() {
        try {
            if (coming_.valid()) bytes_ = coming_.get();
        } catch (...) {
            fault_ = std::current_exception();
        }
        if (fault_) zip_error_set(&error_, ZIP_ER_READ, 0);
        return !fault_;
    }

    zip_int64_t describe(void* data) {
        if (!arrived()) return -1;
        auto* stat = static_cast<zip_stat_t*>(data);
        zip_stat_init(stat);
        stat->size = stat->comp_size = bytes_.size();
        stat->comp_method = ZIP_CM_STORE;
        stat->encryption_method = ZIP_EM_NONE;
        stat->valid =
            ZIP_STAT_SIZE | ZIP_STAT_COMP_SIZE | ZIP_STAT_COMP_METHOD | ZIP_STAT_ENCRYPTION_METHOD;
        return sizeof(zip_stat_t);
    }

    zip_int64_t read(void* data, zip_uint64_t size) {
        const std::size_t count = std::min<std::size_t>(size, bytes_.size() - read_);
        std::copy_n(bytes_.begin() + static_cast<std::ptrdiff_t>(read_), count,
                    static_cast<std::byte*>(data));
        read_ += count;
        return static_cast<zip_int64_t>(count);
    }

    std::future<Bytes> coming_;
    Bytes bytes_;
    std::size_t read_ = 0;
    std::exception_ptr fault_;
    zip_error_t error_;
};

void add_entry(zip_t* archive, const std::string& entry, Content& content, const std::string& name) {
    zip_source_t* source = zip_source_function(archive, &Content::answer, &content);
    const zip_int64_t index =
        source == nullptr ? -1 : zip_file_add(archive, entry.c_str(), source, ZIP_FL_ENC_UTF_8);
    if (index < 0) {
        zip_source_free(source);
        fail_writing(name, zip_get_error(archive));
    }
    const auto place = static_cast<zip_uint64_t>(index);
    if (zip_set_file_compression(archive, place, ZIP_CM_STORE, 0) != 0 ||
        zip_file_set_dostime(archive, place, 0, kDosDate, 0) != 0)
        fail_writing(name, zip_get_error(archive));
}

/// The source that is made of it closes it.
std::FILE* stream_of(const std::filesystem::path& path) {
    const core::RegularFile file(path);
    const int copy = ::fcntl(file.descriptor(), F_DUPFD_CLOEXEC, 0);
    std::FILE* stream = copy < 0 ? nullptr : ::fdopen(copy, "rb");
    if (stream != nullptr) return stream;
    const std::string reason = std::strerror(errno);
    if (copy >= 0) ::close(copy);
    throw core::InputError("%1: cannot be opened (%2).", path.string(), reason);
}

Archive opened(zip_source_t* source, const std::string& name, zip_error_t* error) {
    Archive archive(source == nullptr ? nullptr : zip_open_from_source(source, ZIP_RDONLY, error));
    if (archive) return archive;
    zip_source_free(source);
    throw core::InputError("%1: is no painting of Pastoso, or its end is missing (%2).", name,
                           zip_error_strerror(error));
}

}  // namespace

void ZipWriter::add(std::string name, std::future<Bytes> content) {
    entries_.push_back({std::move(name), std::move(content)});
}

void ZipWriter::add(std::string name, Bytes content) {
    std::promise<Bytes> ready;
    ready.set_value(std::move(content));
    add(std::move(name), ready.get_future());
}

void ZipWriter::add(std::string name, const std::string& content) {
    add(std::move(name), copied(content));
}

void ZipWriter::add(std::string name, std::function<std::string()> make) {
    add(std::move(name),
        std::async(std::launch::deferred, [make = std::move(make)] { return copied(make()); }));
}

void ZipWriter::write(core::OutputFile& file) {
    const std::string name = file.path().string();
    ZipDestination destination(file);  // the archive points to it and to the contents
    std::deque<Content> contents;
    Archive archive = create(destination, name);
    for (Entry& entry : entries_)
        add_entry(archive.get(), entry.name, contents.emplace_back(std::move(entry.content)), name);
    if (zip_close(archive.get()) != 0) {
        for (const Content& content : contents)
            content.rethrow();
        fail_writing(name, zip_get_error(archive.get()));
    }
    archive.release();
    file.check();
}

struct ZipReader::Archive {
    project::Archive zip;
};

ZipReader::ZipReader(const std::filesystem::path& path, core::Progress progress)
    : name_(path.string()), progress_(std::move(progress)) {
    zip_error_t error;
    zip_error_init(&error);
    zip_source_t* source = zip_source_filep_create(stream_of(path), 0, -1, &error);
    archive_ = std::make_unique<Archive>(Archive{opened(source, name_, &error)});
    std::error_code unknown;
    file_bytes_ = std::filesystem::file_size(path, unknown);
    if (unknown) file_bytes_ = 0;
}

ZipReader::ZipReader(std::span<const std::byte> archive, std::string name) : name_(std::move(name)) {
    zip_error_t error;
    zip_error_init(&error);
    zip_source_t* source = zip_source_buffer_create(archive.data(), archive.size(), 0, &error);
    archive_ = std::make_unique<Archive>(Archive{opened(source, name_, &error)});
}

ZipReader::~ZipReader() = default;

void ZipReader::fail(const std::string& entry, const core::Message& sentence) const {
    throw core::InputError("%1, %2: %3", name_, entry, sentence);
}

bool ZipReader::has(const std::string& entry) const {
    const std::lock_guard lock(mutex_);
    return zip_name_locate(archive_->zip.get(), entry.c_str(), 0) >= 0;
}

/// Before something is read: a work that is given up reads nothing more. The lock is held.
void ZipReader::tell() const {
    if (progress_ && file_bytes_ > 0)
        progress_(std::min(1.0, static_cast<double>(read_bytes_) / static_cast<double>(file_bytes_)));
}

Bytes ZipReader::read(const std::string& entry, std::size_t most_bytes) const {
    const std::lock_guard lock(mutex_);
    tell();
    zip_t* archive = archive_->zip.get();
    zip_stat_t stat;
    if (zip_stat(archive, entry.c_str(), 0, &stat) != 0 || (stat.valid & ZIP_STAT_SIZE) == 0)
        fail(entry, "is missing.");
    if (stat.size > most_bytes)
        fail(entry, "holds %1 bytes, but at most %2 are possible here.", stat.size, most_bytes);
    Bytes content(stat.size);
    const std::unique_ptr<zip_file_t, CloseFile> file(zip_fopen_index(archive, stat.index, 0));
    if (!file) fail(entry, "cannot be read (%1).", text_of(zip_get_error(archive)));
    const zip_int64_t count = zip_fread(file.get(), content.data(), content.size());
    std::byte beyond;
    // The checksum of the archive is compared when its end is met.
    const bool ended = zip_fread(file.get(), &beyond, 1) == 0;
    if (count < 0 || static_cast<std::size_t>(count) != content.size() || !ended)
        fail(entry, "is damaged (%1).", text_of(zip_file_get_error(file.get())));
    read_bytes_ += stat.comp_size;
    return content;
}

}  // namespace pastoso::project
