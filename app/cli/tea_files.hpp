// Frames of tea as numbered files (frame_files.hpp).
#pragma once

#include "cli/frame_files.hpp"
#include "liquid/tea/cup.hpp"
#include "liquid/tea/milk_surface.hpp"
#include "liquid/tea/tea_frame.hpp"

#include <filesystem>

namespace pastoso::cli {

class TeaFiles {
  public:
    /// Throws as FrameFiles does, before anything is made.
    TeaFiles(std::filesystem::path folder, const FrameFileOptions& options, const liquid::Cup& cup,
             core::ThreadPool& pool);

    bool is_wanted(int frame) const { return files_.is_wanted(frame); }

    /// Makes the milk's surface and the file of whatever kind is wanted. Throws as FrameFiles does.
    void write(int number, const liquid::TeaFrame& frame);

    const liquid_files::FrameCosts& costs() const { return files_.costs(); }

  private:
    liquid::TriangleMesh surface_of(const liquid::TeaFrame& frame);
    void write_volume(int number, const liquid::TeaFrame& frame);

    FrameFiles files_;
    liquid::Cup cup_;
    liquid::MilkSurfaces surfaces_;
};

}  // namespace pastoso::cli
