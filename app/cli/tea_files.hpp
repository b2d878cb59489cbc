// Frames of tea as numbered files (frame_files.hpp).
#pragma once

#include "cli/frame_files.hpp"
#include "liquid/tea/milk_density.hpp"
#include "liquid/tea/milk_surface.hpp"
#include "liquid/tea/tea_frame.hpp"
#include "liquid/tea/tea_settings.hpp"
#include "trace/tea_scene.hpp"

#include <filesystem>

namespace pastoso::cli {

class TeaFiles {
  public:
    /// Throws as FrameFiles does, before anything is made.
    TeaFiles(std::filesystem::path folder, const FrameFileOptions& options,
             const liquid::TeaSettings& settings, trace::MilkBody body, core::ThreadPool& pool);

    bool is_wanted(int frame) const { return files_.is_wanted(frame); }

    /// Makes the milk and the file of whatever kind is wanted. Throws as FrameFiles does.
    void write(int number, const liquid::TeaFrame& frame);

    const liquid_files::FrameCosts& costs() const { return files_.costs(); }

  private:
    trace::Scene scene_of(const liquid::TeaFrame& frame);
    liquid::Cup cup_in(const liquid::TeaFrame& frame) const;
    liquid::TriangleMesh surface_of(const liquid::TeaFrame& frame);
    void write_volume(int number, const liquid::TeaFrame& frame);

    FrameFiles files_;
    liquid::TeaSettings settings_;
    trace::MilkBody body_;
    liquid::MilkDensities densities_;
    liquid::MilkSurfaces surfaces_;
};

}  // namespace pastoso::cli
