// What the command line asks for, as plain data.
#pragma once

#include "recordings/picture_style.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pastoso::cli {

/// An option that is not given leaves the decision to the recording, or to the defaults of text
/// recordings.
struct ReplayOptions {
    std::string strokes;
    std::optional<std::string> brush;
    std::optional<double> size_mm;
    std::vector<std::string> paints;
    std::optional<std::string> palette;  ///< a .gpl file whose names stand for paints
    std::optional<std::string> medium;
    std::optional<std::string> canvas;
    std::optional<double> px_per_mm;
    std::optional<std::string> support;
    std::optional<double> relief_mm;
    std::optional<double> tilt_deg;
    std::optional<double> tilt_direction_deg;
    std::optional<double> drying_speed;
    std::optional<double> seconds;
    bool fit = false;
    int threads = 0;
    std::string output;
    std::string well;
    std::string save;  ///< a project file
    std::string stats;
    std::string frames;
    double fps = 25.0;
    double scale = 1.0;
    recordings::PictureOptions picture;
    bool quiet = false;
};

struct ExportOptions {
    std::string project;
    std::string output;  ///< a picture, layers, a relief, or a painting that is painted again
    std::string well;
    std::optional<double> again_px_per_mm;  ///< to paint it again on such cells first
    double scale = 1.0;
    recordings::PictureOptions picture;
    bool layers = false;  ///< channel groups instead of the lit picture alone
    bool maps = false;    ///< a set of maps named by the output
    bool flat = false;    ///< without light and shade
    double base_mm = 2.0;
    double exaggeration = 1.0;
    double resolution_mm = 0.0;
    int threads = 0;
    bool quiet = false;
};

/// A picture or a painting, and what it is to become.
struct ConvertOptions {
    std::string source;
    std::string output;
    std::string as = "paint";  ///< or "support"
    double px_per_mm = 4.0;
    double width_mm = 0.0;  ///< of the canvas; 0: as the picture says
    std::string support = "linen";
    double relief_mm = 0.0;  ///< of the support; 0: its own
    double scale = 1.0;      ///< of a picture that is made
    recordings::PictureOptions picture;
    int threads = 0;
    bool quiet = false;
};

struct TimelapseOptions {
    std::string source;  ///< a recording or a project file
    std::string output;  ///< a folder or a video
    double fps = 25.0;
    double speed = 10.0;  ///< seconds of painting in a second of film
    std::optional<double> px_per_mm;
    bool flat = false;  ///< without light and shade
    double scale = 1.0;
    recordings::PictureOptions picture;
    int threads = 0;
    bool quiet = false;
};

struct RecoverOptions {
    std::string name;  ///< of a journal; empty: the latest
    std::string output;
    bool list = false;
    bool discard = false;
    bool keep = false;  ///< the journal
    int threads = 0;
    bool quiet = false;
};

struct ThumbnailOptions {
    std::string project;
    std::string output;
    int longest_px = 256;
};

struct SimulateOptions {
    std::string scene;   ///< a file, or the name of a scene that comes with the program
    std::string output;  ///< folder
    std::optional<double> seconds;
    std::optional<int> threads;
    std::string stats;
    recordings::PictureOptions picture;
    bool quiet = false;
};

struct ValidateOptions {
    std::vector<std::string> cases;  ///< none: all
    bool list = false;
    std::string scheme = "both";  ///< or explicit, large
    bool with_long = false;
    std::string output;  ///< folder, empty: none
    int threads = 0;
    bool quiet = false;
};

/// How frames of a liquid become files.
struct FrameFileOptions {
    std::string format = "png";  ///< the files' ending
    std::string size = "800x800";
    int samples = 48;     ///< a pixel
    int pbrt_syntax = 4;  ///< version of PBRT: 4, 3 or 2
    int every = 1;        ///< a file for every so many frames
};

struct TeaOptions {
    std::string scene;  ///< a file; empty: the usual tea
    double seconds = 45.0;
    double fps = 30.0;
    std::optional<int> cells, parcels;
    std::optional<std::uint32_t> seed;
    bool classic = false;        ///< the system of 2010 in place of the glass
    std::string frames;          ///< folder for files, empty: none
    std::string cache;           ///< folder for frames to be drawn later, empty: none
    double checkpoint_s = 60.0;  ///< of work, between two states that are kept beside them
    FrameFileOptions files;
    std::string milk = "medium";  ///< in pictures: medium or surface
    std::string stats;
    int threads = 0;
    bool quiet = false;
};

struct TeaRenderOptions {
    std::string cache;
    std::string range;   ///< "FIRST-LAST"; empty: all
    std::string frames;  ///< folder
    FrameFileOptions files;
    std::string milk = "medium";  ///< as TeaOptions
    std::string stats;
    int threads = 0;
    bool quiet = false;
};

struct TankOptions {
    std::string scene;  ///< a file, or the name of a scene that comes with the program
    double seconds = 4.0;
    double fps = 30.0;
    std::string method;          ///< empty: the scene's
    std::string frames;          ///< folder for files, series and checkpoint, empty: none
    double checkpoint_s = 60.0;  ///< of work, between two states that are kept there
    FrameFileOptions files;
    std::string stats;
    int threads = 0;
    bool quiet = false;
};

struct InfoOptions {
    /// None: the program itself. A file; or "paints", "paint NAME", "closest COLOUR [PAINT...]",
    /// "palette FILE".
    std::vector<std::string> about;
};

}  // namespace pastoso::cli
