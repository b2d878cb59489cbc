// Frames of a tank as numbered files (frame_files.hpp), and what is measured of them.
#pragma once

#include "cli/frame_files.hpp"
#include "tank/liquid_tank.hpp"
#include "tank/tank_surface.hpp"

#include <filesystem>
#include <optional>

namespace pastoso::cli {

/// A frame's surface as it is measured and written, cut where glass and solids begin.
struct MeasuredFrame {
    tank::TankFrame frame;
    liquid::TriangleMesh surface;
    double front_x_m = 0.0;
};

/// Makes what is measured of the tank as it stands.
class TankMeasures {
  public:
    TankMeasures(const tank::LiquidTank& tank, core::ThreadPool& pool)
        : tank_(tank), pool_(pool), surfaces_(tank.domain(), pool) {}
    MeasuredFrame measured();

  private:
    const tank::LiquidTank& tank_;
    core::ThreadPool& pool_;
    tank::TankSurfaces surfaces_;
};

class TankFiles {
  public:
    /// Throws as FrameFiles does, before anything is made. The tank outlives it.
    TankFiles(std::filesystem::path folder, const FrameFileOptions& options,
              const tank::LiquidTank& tank, core::ThreadPool& pool);

    bool is_wanted(int frame) const { return files_.is_wanted(frame); }

    /// Of a frame of the tank as it stands. Throws as FrameFiles does.
    void write(int number, const MeasuredFrame& measured);

    const liquid_files::FrameCosts& costs() const { return files_.costs(); }

  private:
    void write_picture(int number, const tank::TankFrame& frame);
    void write_volume(int number, const tank::TankFrame& frame);

    const tank::LiquidTank& tank_;
    core::ThreadPool& pool_;
    FrameFiles files_;
    tank::TankSurfaces surfaces_;                 ///< that reach into the glass
    std::optional<liquid::TriangleMesh> solids_;  ///< of the first picture: they stay where they are
};

}  // namespace pastoso::cli
