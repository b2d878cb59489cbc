// Frames of tea as numbered files: path-traced pictures, meshes of the milk, scenes for PBRT, volumes.
#pragma once

#include "cli/options.hpp"
#include "core/thread_pool.hpp"
#include "io/mesh_export.hpp"
#include "io/tea_stats.hpp"
#include "liquid/cup.hpp"
#include "liquid/milk_surface.hpp"
#include "liquid/tea_frame.hpp"
#include "trace/scene.hpp"

#include <filesystem>

namespace pastoso::cli {

class TeaFiles {
  public:
    /// Throws UsageError for a size that is none, and for a format that this program has not, before
    /// anything is made.
    TeaFiles(std::filesystem::path folder, const TeaPictureOptions& options, const liquid::Cup& cup,
             core::ThreadPool& pool);

    /// Whether a file is to be made of this frame, from 1: it is one of every so many, and is not there.
    bool is_wanted(int frame) const;

    /// "FOLDER/milk_0001.png". Frames are told apart by their number alone.
    std::filesystem::path path_of(int frame) const;

    /// Writes the file aside. Throws Interrupted when the user stops it, and InputError when it cannot
    /// be written.
    void write(int number, const liquid::TeaFrame& frame);

    /// The same of a surface that stands alone; the format is one of meshes.
    void write_surface(int number, const liquid::TriangleMesh& surface);

    /// Adds the files and seconds so far.
    void add_to(io::TeaStats& stats) const;

  private:
    enum class Kind { Picture, Mesh, Scene, Volume };
    static Kind kind_of(const std::string& format);

    void write_mesh(const std::filesystem::path& path, const liquid::TriangleMesh& mesh);
    void write_scene(const std::filesystem::path& path, const liquid::TeaFrame& frame,
                     const liquid::TriangleMesh& milk);
    void write_volume(const std::filesystem::path& path, const liquid::TeaFrame& frame);
    void write_picture(const std::filesystem::path& path, const trace::Scene& scene);

    std::filesystem::path folder_;
    TeaPictureOptions options_;
    liquid::Cup cup_;
    core::ThreadPool& pool_;
    liquid::MilkSurfaces surfaces_;
    Kind kind_;
    io::MeshExportOptions mesh_;
    int width_px_ = 0, height_px_ = 0;
    io::TeaStats stats_;
};

}  // namespace pastoso::cli
