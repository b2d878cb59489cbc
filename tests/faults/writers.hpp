// Every file that pastoso-cli writes: what it is asked for, and what it leaves.
#pragma once

#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

namespace pastoso::faults {

/// A run of pastoso-cli that writes into one folder.
struct Writer {
    std::string name;
    std::vector<std::string> arguments;  ///< IN/ stands for the folder of inputs, OUT/ for that of outputs
    bool replaces = true;                ///< old files in OUT are replaced; otherwise it wants an empty folder
};
std::ostream& operator<<(std::ostream& stream, const Writer& writer);

const std::vector<Writer>& writers();

/// A painting, recordings, a picture, a tank and a scene, all small.
void make_inputs(const std::filesystem::path& folder);

}  // namespace pastoso::faults
