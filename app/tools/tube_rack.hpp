// The tubes in the painter's order, and choices of them by name.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pastoso::tools {

/// Tubes by their Colour Index names; empty for the clear medium.
using Tubes = std::vector<std::string>;

struct TubeSet {
    std::string name;  ///< not empty, and the only one of that name
    Tubes tubes;
    friend bool operator==(const TubeSet&, const TubeSet&) = default;
};

struct TubeRack {
    Tubes order;  ///< of all tubes; those left out follow as they ship
    std::vector<TubeSet> sets;
    std::string chosen;  ///< the set that is shown; empty, or of none there is: all tubes
    friend bool operator==(const TubeRack&, const TubeRack&) = default;
};

/// Null where all tubes are shown.
const TubeSet* chosen_set(const TubeRack& rack);

/// The tubes that are shown of `all`, in the painter's order.
Tubes shown_tubes(const TubeRack& rack, const Tubes& all);

/// Gives what is shown this order. Tubes of the set that there are not at present are last in it.
void arrange(const Tubes& shown, TubeRack& rack);

/// Makes a set of these tubes and chooses it. One of that name is replaced. False for a name of blanks.
bool save_set(const std::string& name, const Tubes& tubes, TubeRack& rack);

/// Renames the chosen set. False for a name of blanks, one that another set has, and where none is.
bool rename_chosen(const std::string& name, TubeRack& rack);

/// Removes the chosen set; all tubes are shown.
void remove_chosen(TubeRack& rack);

/// Puts a tube last in the set of that name, unless it is in it; takes one out of the chosen set.
void put_into_set(const std::string& tube, const std::string& set, TubeRack& rack);
void take_out(const std::string& tube, TubeRack& rack);

/// Adds the sets that are not there yet, each under its name or, where another set has it, with a number
/// behind it. How many were added.
int add_sets(const std::vector<TubeSet>& sets, TubeRack& rack);

/// Sets as other painters may have them. Both throw InputError: where the file cannot be written, or
/// names the file and the place of what is malformed in it.
void write_tube_sets(const std::vector<TubeSet>& sets, const std::filesystem::path& file);
std::vector<TubeSet> read_tube_sets(const std::filesystem::path& file);

/// As paint_shelf.hpp does it. Names of tubes are not checked: a painter's own may be away.
TubeRack read_rack(const std::filesystem::path& file);
void write_rack(const TubeRack& rack, const std::filesystem::path& file);

}  // namespace pastoso::tools
