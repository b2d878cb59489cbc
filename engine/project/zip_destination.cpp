#include "project/zip_destination.hpp"

#include <cerrno>

namespace pastoso::project {

ZipDestination::ZipDestination(core::OutputFile& file) : file_(file) {
    zip_error_init(&error_);
}

zip_source_t* ZipDestination::source(zip_error_t* error) {
    return zip_source_function_create(&ZipDestination::answer, this, error);
}

zip_int64_t ZipDestination::answer(void* destination, void* data, zip_uint64_t size,
                                   zip_source_cmd_t question) {
    return static_cast<ZipDestination*>(destination)->answer(data, size, question);
}

zip_int64_t ZipDestination::answer(void* data, zip_uint64_t size, zip_source_cmd_t question) {
    switch (question) {
        case ZIP_SOURCE_BEGIN_WRITE:
        case ZIP_SOURCE_COMMIT_WRITE:
        case ZIP_SOURCE_ROLLBACK_WRITE:
        case ZIP_SOURCE_FREE:
            return 0;
        case ZIP_SOURCE_WRITE:
            return write(data, size);
        case ZIP_SOURCE_SEEK_WRITE:
            return seek(data, size);
        case ZIP_SOURCE_TELL_WRITE:
            return static_cast<zip_int64_t>(place_);
        case ZIP_SOURCE_STAT:
            return refuse(ZIP_ER_READ, ENOENT);
        case ZIP_SOURCE_ERROR:
            return zip_error_to_data(&error_, data, size);
        case ZIP_SOURCE_SUPPORTS:
            return ZIP_SOURCE_SUPPORTS_WRITABLE | ZIP_SOURCE_MAKE_COMMAND_BITMASK(ZIP_SOURCE_WRITE);
        default:
            return refuse(ZIP_ER_OPNOTSUPP, 0);
    }
}

zip_int64_t ZipDestination::write(const void* data, zip_uint64_t size) {
    file_.write_at(place_, std::span(static_cast<const std::byte*>(data), size));
    place_ += size;
    return static_cast<zip_int64_t>(size);
}

zip_int64_t ZipDestination::seek(void* data, zip_uint64_t size) {
    const zip_int64_t place = zip_source_seek_compute_offset(place_, file_.size(), data, size, &error_);
    if (place >= 0) place_ = static_cast<std::uint64_t>(place);
    return place < 0 ? -1 : 0;
}

zip_int64_t ZipDestination::refuse(int reason, int system_reason) {
    zip_error_set(&error_, reason, system_reason);
    return -1;
}

}  // namespace pastoso::project
