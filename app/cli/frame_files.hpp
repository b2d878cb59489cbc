// Frames of a liquid as numbered files of one format: path-traced pictures, meshes of its surface,
// scenes for PBRT, volumes. What is there already is kept, so that a sequence goes on where it was
// stopped.
#pragma once

#include "cli/options.hpp"
#include "core/thread_pool.hpp"
#include "liquid_files/frame_costs.hpp"
#include "liquid_files/mesh_export.hpp"
#include "liquid_files/pbrt_scene.hpp"
#include "liquid_files/vdb_export.hpp"
#include "trace/scene.hpp"

#include <filesystem>
#include <string>

namespace pastoso::cli {

class FrameFiles {
  public:
    enum class Kind { Picture, Mesh, Scene, Volume };
    static Kind kind_of(const std::string& format);

    /// Files are named "FOLDER/NAME_0001.png", scenes "FOLDER/scene_0001.pbrt"; the name stands in
    /// meshes as well. Makes the folder. Throws UsageError for a size that is none and for a format that
    /// this program has not, InputError when the folder cannot be made.
    FrameFiles(std::filesystem::path folder, std::string name, const FrameFileOptions& options,
               core::ThreadPool& pool);

    Kind kind() const { return kind_; }
    /// Of pictures: width over height.
    float aspect() const { return static_cast<float>(width_px_) / static_cast<float>(height_px_); }

    /// Whether a file is to be made of this frame, from 1: it is one of every so many, and is not there.
    bool is_wanted(int frame) const;

    /// Frames are told apart by their number alone.
    std::filesystem::path path_of(int frame) const;

    // Each writes the file aside. They throw Interrupted when the user stops it, and InputError when it
    // cannot be written. The kind is the one that is called for.

    void write_mesh(int frame, const liquid::TriangleMesh& mesh);
    void write_picture(int frame, const trace::Scene& scene);
    /// Syntax, size and samples are those of the options; what the syntax cannot hold is left out.
    void write_scene(int frame, liquid_files::PbrtScene scene);
    void write_volume(int frame, const liquid_files::VdbFields& fields);

    /// So far. Whoever makes the surfaces notes them here.
    liquid_files::FrameCosts& costs() { return costs_; }
    const liquid_files::FrameCosts& costs() const { return costs_; }

  private:
    std::filesystem::path folder_;
    std::string name_;
    FrameFileOptions options_;
    core::ThreadPool& pool_;
    Kind kind_;
    liquid_files::MeshExportOptions mesh_;
    int width_px_ = 0, height_px_ = 0;
    liquid_files::FrameCosts costs_;
};

}  // namespace pastoso::cli
