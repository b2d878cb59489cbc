// A picture file that is read a few rows at a time, so that no more of it than that must be held.
#pragma once

#include "core/error.hpp"
#include "core/regular_file.hpp"
#include "files/colour_profile.hpp"

#include <filesystem>
#include <memory>
#include <string>

namespace pastoso::files {

inline constexpr int kMaxPictureSide_px = 32768;
inline constexpr double kMaxPicturePixels = 1e8;

/// What a picture file says of itself before its pixels.
struct PictureHead {
    int width = 0, height = 0;
    int colours = 3;                  ///< of a pixel's channels: 1 or 3
    bool has_alpha = false;           ///< one more channel
    bool colours_have_alpha = false;  ///< they are multiplied by it (associated)
    StoredColour meaning;
    bool profile_is_damaged = false;
    int orientation = 1;                        ///< of EXIF (upright.hpp)
    double px_per_mm_x = 0, px_per_mm_y = 0.0;  ///< 0: not said
    int rows_at_once = 1;                       ///< rows come in multiples of this, but for the last

    int channels() const { return colours + (has_alpha ? 1 : 0); }
};

class PictureRows {
  public:
    virtual ~PictureRows() = default;

    const PictureHead& head() const { return head_; }

    /// Puts the next `count` rows at `rows`, channels interleaved, integers as 0 to 1. Throws InputError
    /// when the file is cut off or damaged.
    virtual void read(int count, float* rows) = 0;

    /// After the last row. Throws InputError when the file's end is missing.
    virtual void finish() = 0;

  protected:
    PictureHead head_;
};

/// Opens a picture by what the file holds (picture_format.hpp), whatever its name. Throws InputError
/// "NAME: ..." when it is none, or has more than 32768 pixels a side, 100 million in all or 1 GiB of
/// values; before room is made for any of them.
std::unique_ptr<PictureRows> open_picture(const std::filesystem::path& path);

/// "NAME: PREDICATE"; without a name, "the picture PREDICATE", as of one in memory.
core::InputError picture_error(const std::string& name, const core::Message& predicate);

/// Throws picture_error() "has W x H pixels, ..." for more pixels than that. A side of 0 passes.
void check_picture_size(const std::string& name, double width, double height);

}  // namespace pastoso::files
