// A file in the making, as libzip writes to it.
#pragma once

#include "core/output_file.hpp"

#include <cstdint>
#include <zip.h>

namespace pastoso::project {

/// Where libzip puts a new archive: nothing stands there, and no failure is told to it, which `file` keeps.
class ZipDestination {
  public:
    /// `file` outlives what is written to it, and so does this.
    explicit ZipDestination(core::OutputFile& file);

    /// To be opened by libzip, which then owns it; null where there is no memory.
    zip_source_t* source(zip_error_t* error);

  private:
    static zip_int64_t answer(void* destination, void* data, zip_uint64_t size, zip_source_cmd_t question);
    zip_int64_t answer(void* data, zip_uint64_t size, zip_source_cmd_t question);
    zip_int64_t write(const void* data, zip_uint64_t size);
    zip_int64_t seek(void* data, zip_uint64_t size);
    zip_int64_t refuse(int reason, int system_reason);

    core::OutputFile& file_;
    std::uint64_t place_ = 0;
    zip_error_t error_{};
};

}  // namespace pastoso::project
