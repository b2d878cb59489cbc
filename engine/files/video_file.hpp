// A video, made by the program ffmpeg where that is installed: it runs beside us and is handed the
// frames.
#pragma once

#include "core/output_file.hpp"
#include "pigment/image.hpp"

#include <filesystem>
#include <functional>
#include <string>

namespace pastoso::files {

/// Whether a file's name ends in .mp4, .mkv or .webm.
bool is_video_path(const std::filesystem::path& path);

/// Where the program of this name lies on the PATH; empty where it does not.
std::filesystem::path find_program(const std::string& name);

/// Asked before long work: throws InputError when ffmpeg is not installed or the file cannot be written.
void check_video_path(const std::filesystem::path& path);

/// ffmpeg at work on a file.
class VideoWriter {
  public:
    /// ffmpeg writes the part file of `file`, in the format that its name ends in. Throws InputError when ffmpeg
    /// cannot be started.
    VideoWriter(const core::OutputFile& file, int width, int height, double fps);
    ~VideoWriter();
    VideoWriter(const VideoWriter&) = delete;
    VideoWriter& operator=(const VideoWriter&) = delete;

    /// The next frame, of the video's size. Throws InputError with what ffmpeg said when it has ended.
    void write(const pigment::Image8& frame);

    /// After the last frame: waits for ffmpeg to complete the file. Throws InputError when it failed.
    void finish();

  private:
    [[noreturn]] void fail();
    int wait();

    std::filesystem::path path_, part_;
    int width_, height_;
    int complaints_ = -1;  ///< a file in memory of what ffmpeg prints
    int pipe_ = -1;
    int process_ = -1;
};

}  // namespace pastoso::files
