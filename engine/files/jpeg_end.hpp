// Whether a JPEG file is whole.
#pragma once

#include "core/regular_file.hpp"

namespace pastoso::files {

/// Whether the markers of a JPEG file lead to its end (ISO/IEC 10918-1, B.2). One that is cut off has
/// none; libjpeg fills up what is missing with grey.
bool jpeg_has_end(const core::RegularFile& file);

}  // namespace pastoso::files
