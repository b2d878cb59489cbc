// Paint on its way from one painting to another, as bytes: what the clipboard and recordings hold of it
// (docs/file-format.md, "Copied paint").
#pragma once

#include "document/actions/copy_actions.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace pastoso::recordings {

inline constexpr int kPieceFormatVersion = 1;

/// Of one piece that is read, unpacked: all of a canvas of 14 million cells with everything in every
/// cell.
inline constexpr std::uint64_t kMostPiece_bytes = std::uint64_t{4} << 30;
/// The same of all pieces in a recording.
inline constexpr std::uint64_t kMostRecordedPieces_bytes = std::uint64_t{16} << 30;

/// All that the paint is, without loss; the same paint gives the same bytes.
std::string piece_bytes(const film::FilmState& paint);

struct PaintPiece {
    document::CopiedPaint paint;
    std::uint64_t unpacked_bytes = 0;
};
/// Reads the same. `name` stands for the bytes in errors. Throws InputError for anything malformed, out
/// of range, damaged, cut off, written by a newer version, or larger than kMostPiece_bytes.
PaintPiece piece_of(std::string_view bytes, const std::string& name);

}  // namespace pastoso::recordings
