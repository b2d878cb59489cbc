// Values of actions that have a form of their own in recordings.
#pragma once

#include "document/actions/actions.hpp"
#include "files/json_place.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pastoso::recordings {

/// The name of a preset that comes with the program, or all of another one.
files::Json value_json(const document::TakeBrush& take);
files::Json value_json(const std::string& name);
files::Json value_json(const std::optional<film::Medium>& numbers);
/// {"mix": [["PB29", 62], ["PW6", 38]], "strength": 0.4}; the strength only where it is not 1.
files::Json value_json(const document::PaintRecipe& paint);
files::Json value_json(document::Combination how);
files::Json value_json(const std::vector<document::CanvasPoint>& outline);
files::Json value_json(const std::vector<document::LayerId>& layers);
/// A PNG file in base64.
files::Json value_json(const document::SharedPicture& picture);
/// The PNG file that it was packed into.
files::Json value_json(const document::SharedReferencePicture& picture);
/// As on the clipboard (paint_piece.hpp), in base64.
files::Json value_json(const document::CopiedPaint& paint);
files::Json value_json(document::Surface surface);

/// Reads the values of one recording. `object` is what has `place` as an entry. Throws InputError with
/// the place; ranges are left to document::check_action(), but for what pictures hold in all
/// (document::kMostRecordedPixels), and brought paint (kMostRecordedPieces_bytes).
class ValueReader {
  public:
    void read(const files::JsonPlace& place, const files::JsonPlace& object, document::TakeBrush& take);
    void read(const files::JsonPlace& place, const files::JsonPlace& object, std::string& name);
    void read(const files::JsonPlace& place, const files::JsonPlace& object,
              std::optional<film::Medium>& numbers);
    void read(const files::JsonPlace& place, const files::JsonPlace& object,
              document::PaintRecipe& paint);
    void read(const files::JsonPlace& place, const files::JsonPlace& object, document::Combination& how);
    void read(const files::JsonPlace& place, const files::JsonPlace& object,
              std::vector<document::CanvasPoint>& outline);
    void read(const files::JsonPlace& place, const files::JsonPlace& object,
              std::vector<document::LayerId>& layers);
    void read(const files::JsonPlace& place, const files::JsonPlace& object,
              document::SharedPicture& picture);
    void read(const files::JsonPlace& place, const files::JsonPlace& object,
              document::SharedReferencePicture& picture);
    void read(const files::JsonPlace& place, const files::JsonPlace& object,
              document::CopiedPaint& paint);
    void read(const files::JsonPlace& place, const files::JsonPlace& object, document::Surface& surface);

  private:
    /// A PNG file in base64: its bytes, and what it shows.
    document::ReferencePicture read_png(const files::JsonPlace& place);

    double picture_pixels_ = 0.0;  ///< in all pictures so far
    std::uint64_t piece_bytes_ = 0;  ///< of all brought paint so far, unpacked
};

}  // namespace pastoso::recordings
