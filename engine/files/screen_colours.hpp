// Colours for the screen that they are seen on, as its profile tells; and as a printer would print them.
#pragma once

#include "files/colour_profile.hpp"
#include "pigment/colour_cube.hpp"

#include <memory>

namespace pastoso::files {

/// The profile of a screen, in a file. Throws InputError when the file holds no ICC profile, one for
/// other than red, green and blue, or one that colours can be read but not shown with.
IccProfile read_monitor_profile(const std::filesystem::path& path);

/// The same of a profile that is there already; `name` is what errors call it.
IccProfile monitor_profile(IccProfile bytes, const std::string& name);

/// The profile of a printer, in a file: of whatever inks. Throws InputError when the file holds no ICC
/// profile, or one that does not tell both what a colour is printed with and how that looks.
IccProfile read_printer_profile(const std::filesystem::path& path);

/// What a profile calls itself, in English where it has several names; may be empty. `profile` is one
/// that was read with one of the above.
std::string description_of(const IccProfile& profile);

/// What colours are shown through.
struct ScreenProfiles {
    pigment::WorkingSpace space = pigment::WorkingSpace::Srgb;  ///< that they are encoded in
    IccProfile monitor{};        ///< empty: the screen takes them as they are
    IccProfile printer{};        ///< of the two below, which do nothing where it is empty
    bool soft_proof = false;     ///< as they would be printed
    bool gamut_warning = false;  ///< marks those that cannot be printed
    bool values = false;         ///< as the greys of their luminance
    friend bool operator==(const ScreenProfiles&, const ScreenProfiles&) = default;
};

/// Null when colours are shown as they are.
///
/// They are printed with the profile's perceptual rendering where it has one, otherwise relative to its
/// white with black matched, as in_profile() does it; the print is seen relative to its paper, its black
/// as the screen's. A colour cannot be printed when the nearest that the profile gives, paper and black
/// matched, lies more than a CIE 1976 difference of 5 from it, or 1 where the profile is a matrix and
/// curves, which are exact; these are LittleCMS's bounds.
std::shared_ptr<const pigment::ColourCube> screen_cube(const ScreenProfiles& profiles);

}  // namespace pastoso::files
