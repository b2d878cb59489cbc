// The reports that runs of the program left when they failed.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace pastoso::crash {

struct Report {
    std::filesystem::path file;
    std::string text;  ///< with the names of functions as they are written in C++
};

/// Where they lie; empty where there is no home.
std::filesystem::path reports_folder();

/// The latest that was not taken yet, if there is one that can be read. It and all older ones count as
/// taken from now on; of those, the latest five stay.
std::optional<Report> take_report(const std::filesystem::path& folder);

}  // namespace pastoso::crash
