// Names and sizes in a project file.
#pragma once

#include <cstddef>

namespace pastoso::project {

inline constexpr const char* kMimeType = "image/openraster";

inline constexpr const char* kIndexEntry = "pastoso/index.json";
inline constexpr const char* kSetupEntry = "pastoso/setup.json";
inline constexpr const char* kStrokesEntry = "pastoso/strokes.json.zst";
inline constexpr const char* kBrushEntry = "pastoso/brush.zst";
inline constexpr const char* kBrushAsideEntry = "pastoso/brush-aside.zst";
inline constexpr const char* kSelectionEntry = "pastoso/selection.zst";
inline constexpr const char* kMaskingEntry = "pastoso/masking.zst";
inline constexpr const char* kMaskingTapeEntry = "pastoso/masking-tape.zst";
inline constexpr const char* kTracingEntry = "pastoso/tracing.png";
inline constexpr const char* kReferenceFolder = "pastoso/references/";
inline constexpr const char* kBareSupportFolder = "pastoso/bare/";
inline constexpr const char* kWellFolder = "pastoso/well/";
inline constexpr const char* kCopiedFolder = "pastoso/copied/";

/// No reader takes more.
inline constexpr std::size_t kMostIndexBytes = std::size_t{64} << 20;
inline constexpr std::size_t kMostSetupBytes = std::size_t{4} << 20;
inline constexpr std::size_t kMostMaskBytes = std::size_t{1} << 30;
inline constexpr std::size_t kMostTracingBytes = std::size_t{512} << 20;
inline constexpr std::size_t kMostReferenceBytes = std::size_t{512} << 20;  ///< of each
inline constexpr std::size_t kMostStrokesBytes = std::size_t{512} << 20;

}  // namespace pastoso::project
