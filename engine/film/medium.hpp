// What kind of paint it is: its flow properties, in SI units, and the named kinds that come with the
// program.
#pragma once

#include "core/message.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pastoso::film {

/// Properties of a paint, which it brings with it wherever it goes: viscosity, yield stress, solids and
/// drying time in the channels of a cell (paint_cell.hpp), the others by its medium (wet_media.hpp). The
/// ranges are where the model was tried; outside them it stays stable but need not look like paint.
struct Medium {
    std::string name;
    std::string description;        ///< one sentence for the painter
    double density_kg_m3 = 1200.0;  ///< 800 to 2500
    double viscosity_m2_s = 0.003;  ///< kinematic, 1e-6 (water) to 1 (stiff paste)
    /// n of Herschel and Bulkley, 0.2 to 1: below 1 the paint thins as it is sheared, and the viscosity
    /// is that at a wall shear rate of 1/s. Followed from 1e-3 to 1e4 1/s.
    double flow_index = 1.0;
    double yield_stress_Pa = 0.0;       ///< 0 (runs for ever) to 200 (stands in peaks)
    /// Of viscosity and yield stress, what is lost in paint that is worked, 0 to 0.95
    /// (cell/structure.hpp).
    double structure_share = 0.0;
    double recovery_s = 10.0;           ///< in which all but 1/e of it comes back at rest, 0.1 to 1000
    double breakdown_strain = 10.0;     ///< shear that takes all but 1/e of it, 0.1 to 1000
    double surface_tension_N_m = 0.03;  ///< 0.02 to 0.07
    double advancing_angle_deg = 27.0;  ///< contact angle at which the edge moves out, 0 to 60
    double receding_angle_deg = 10.0;   ///< contact angle at which the edge draws back, 0 to advancing
    double slip_cells = 0.2;            ///< Navier slip length at the support, cell sizes
    double alpha_min = 1.0;  ///< where the velocity profile peaks, in h: tension against the flow
    double alpha_max = 1.0;  ///< tension with the flow; 1/3 < alpha_min <= alpha_max
    double typical_thickness_mm = 0.5;  ///< what a loaded brush leaves
    double solid_fraction = 1.0;        ///< thickness that stays when it dries, 0 to 1 of the wet one
    double touch_dry_s = 3600.0;        ///< until a film of the typical thickness is touch-dry, 1 to 1e7
    /// How much of a full-strength paint is in it by volume, 0.0005 to 1: the rest is clear. K and S of
    /// a paint are this times those of its pigment.
    double pigment_share = 1.0;
    std::string thinned_with{};  ///< the medium that thins it (film/thinning.hpp); "" for none

    friend bool operator==(const Medium&, const Medium&) = default;
};

/// touch_dry_s is at most this times typical_thickness_mm, 1000 hours a millimetre: keeps the drying
/// time of the thickest paint within its channel.
inline constexpr double kSlowestDrying_s_mm = 3.6e6;

/// A number of a medium and where it may lie.
struct MediumNumber {
    const char* key;  ///< in files
    double Medium::*member;
    double least, most;
    bool optional = false;  ///< the member keeps its default where an entry does not name it
};

/// All of them, in the order of the files.
std::span<const MediumNumber> medium_numbers();

/// Reads a JSON array of media (resources/media.json shows the form). `name` is the file's name for
/// errors. Throws InputError that names the entry, the field and the value, and where one is thinned
/// with a medium that is not in the array or with itself.
std::vector<Medium> parse_media(std::string_view json_text, const std::string& name);

/// One medium from a JSON object with any of the number fields of such an entry; those left out are as
/// in `otherwise`. Throws InputError "PLACE ...: " that names the field and the value.
Medium parse_medium(std::string_view json_object, const core::Message& place, const Medium& otherwise);

/// All numbers of a medium as a JSON object, exactly as parse_medium() reads them.
std::string numbers_to_json(const Medium& medium);

/// Throws InputError "PLACE ...: " that names the field and the value of a number out of its range.
void check_numbers(const Medium& medium, const core::Message& place);

/// The media that come with the program, in the order of the file.
const std::vector<Medium>& bundled_media();

/// The bundled medium of that name. Throws InputError that lists the names there are.
const Medium& find_medium(std::string_view name);

}  // namespace pastoso::film
