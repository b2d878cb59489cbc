// Pictures to look at while painting, on a board of their own beside the canvas.
#pragma once

#include "pigment/image.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace pastoso::document {

/// References are numbered from 1 in the order in which they come to the board; a number is never given
/// twice.
using ReferenceId = std::uint32_t;

inline constexpr std::size_t kMostReferences = 100;
inline constexpr std::size_t kMostReferenceName = 200;

/// Of all pictures on a board: they stay in memory.
inline constexpr double kMostReferencePixels = 2e8;

/// A picture, packed once: painting, file and recording share the bytes.
struct ReferencePicture {
    pigment::Picture pixels;
    std::string png;  ///< a PNG file of the same pixels
    friend bool operator==(const ReferencePicture& a, const ReferencePicture& b) {
        return a.pixels == b.pixels;
    }
};
using SharedReferencePicture = std::shared_ptr<const ReferencePicture>;

/// How a picture lies on the board, which has no edges; x right, y down. Its height follows in
/// proportion.
struct ReferencePlace {
    double x_mm = 0.0, y_mm = 0.0;  ///< of its middle
    double width_mm = 100.0;        ///< before it is turned
    double turn_deg = 0.0;          ///< clockwise
    bool mirrored = false;          ///< left and right, before it is turned
    friend bool operator==(const ReferencePlace&, const ReferencePlace&) = default;
};

struct ReferenceLook {
    double opacity = 1.0;  ///< 0 to 1
    bool grey = false;     ///< shown without its colours
    friend bool operator==(const ReferenceLook&, const ReferenceLook&) = default;
};

struct Reference {
    ReferenceId id = 0;
    std::string name{};                ///< at most kMostReferenceName bytes
    SharedReferencePicture picture{};  ///< not null
    ReferencePlace place{};
    ReferenceLook look{};
    friend bool operator==(const Reference& a, const Reference& b) {
        return a.id == b.id && a.name == b.name && a.place == b.place && a.look == b.look &&
               (a.picture == b.picture || *a.picture == *b.picture);
    }
};

struct ReferenceBoard {
    std::vector<Reference> references;  ///< from below
    ReferenceId next = 1;               ///< the number that is given next
    friend bool operator==(const ReferenceBoard&, const ReferenceBoard&) = default;
};

/// Null: nothing has ever been laid on it.
using SharedReferences = std::shared_ptr<const ReferenceBoard>;

/// Null: there is none of that number.
const Reference* find_reference(const SharedReferences& board, ReferenceId id);

/// Pixels of all pictures.
double pixel_count(const ReferenceBoard& board);

}  // namespace pastoso::document
