#include "files/video_file.hpp"

#include "core/check.hpp"
#include "core/error.hpp"
#include "core/looking.hpp"
#include "core/number_text.hpp"
#include "core/text.hpp"
#include "files/file_access.hpp"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <sstream>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace pastoso::files {
namespace {

using Path = std::filesystem::path;

constexpr const char* kExtensions[] = {".mp4", ".mkv", ".webm"};

/// Colours as high-definition television has them; sides are made even, which most codecs ask for.
constexpr const char* kFilter =
    "pad=ceil(iw/2)*2:ceil(ih/2)*2,scale=out_color_matrix=bt709:out_range=tv,format=yuv420p";

std::vector<std::string> arguments_of(const Path& ffmpeg, const Path& file, int width, int height,
                                      double fps) {
    return {ffmpeg.string(),
            "-nostdin",
            "-loglevel",
            "error",
            "-xerror",
            "-y",
            "-f",
            "rawvideo",
            "-pixel_format",
            "rgb24",
            "-video_size",
            std::to_string(width) + "x" + std::to_string(height),
            "-framerate",
            core::number_text(fps),
            "-i",
            "pipe:0",
            "-an",
            "-vf",
            kFilter,
            "-colorspace",
            "bt709",
            "-color_primaries",
            "bt709",
            "-color_trc",
            "bt709",
            "-fflags",
            "+bitexact",
            "file:" + file.string()};
}

/// What runs in the child between fork and exec: nothing that allocates.
[[noreturn]] void become(char* const* words, int input, int complaints) {
    for (const int signal : {SIGINT, SIGHUP})  // they are for us, who end the child by its input
        ::signal(signal, SIG_IGN);
    ::dup2(input, STDIN_FILENO);
    ::dup2(complaints, STDOUT_FILENO);
    ::dup2(complaints, STDERR_FILENO);
    ::execv(words[0], words);
    ::_exit(127);
}

/// A pipe to a program that is gone gives an error instead of ending us.
void ignore_broken_pipes() {
    ::signal(SIGPIPE, SIG_IGN);
}

/// Empty where nothing is printed.
std::string first_line(int file) {
    std::string text(512, '\0');
    const ssize_t count = ::pread(file, text.data(), text.size(), 0);
    text.resize(count < 0 ? 0 : static_cast<std::size_t>(count));
    return text.substr(0, text.find('\n'));
}

/// ffmpeg knows the part file alone, of which nobody has heard.
std::string with_name(std::string sentence, const Path& part, const Path& path) {
    for (const std::string& known : {"file:" + part.string(), part.string()}) {
        for (std::size_t at = sentence.find(known); at != std::string::npos; at = sentence.find(known))
            sentence.replace(at, known.size(), path.filename().string());
    }
    return sentence;
}

}  // namespace

bool is_video_path(const Path& path) {
    const std::string extension = core::lower_case(path.extension().string());
    for (const char* video : kExtensions)
        if (extension == video) return true;
    return false;
}

Path find_program(const std::string& name) {
    const char* folders = std::getenv("PATH");
    std::istringstream list(folders == nullptr ? "" : folders);
    for (std::string folder; std::getline(list, folder, ':');) {
        const Path program = Path(folder) / name;
        if (core::is_regular_file(program) && ::access(program.c_str(), X_OK) == 0)
            return program;
    }
    return {};
}

void check_video_path(const Path& path) {
    if (find_program("ffmpeg").empty()) {
        throw core::InputError(
            "%1: a video is made by the program ffmpeg, which is not installed; a folder's name instead "
            "gives numbered pictures.",
            path.string());
    }
    check_writable(path);
}

VideoWriter::VideoWriter(const core::OutputFile& file, int width, int height, double fps)
    : path_(file.path()), part_(file.part()), width_(width), height_(height) {
    ignore_broken_pipes();
    const Path ffmpeg = find_program("ffmpeg");
    std::vector<std::string> arguments = arguments_of(ffmpeg, file.part(), width, height, fps);
    std::vector<char*> words;
    for (std::string& argument : arguments)
        words.push_back(argument.data());
    words.push_back(nullptr);
    complaints_ = ::memfd_create("ffmpeg", MFD_CLOEXEC);
    int ends[2] = {-1, -1};
    if (complaints_ >= 0 && ::pipe2(ends, O_CLOEXEC) == 0) process_ = ::fork();
    if (process_ == 0) become(words.data(), ends[0], complaints_);
    const int reason = errno;
    if (ends[0] >= 0) ::close(ends[0]);
    pipe_ = ends[1];
    if (process_ > 0) return;
    if (pipe_ >= 0) ::close(pipe_);
    if (complaints_ >= 0) ::close(complaints_);
    throw core::InputError("%1: ffmpeg cannot be started (%2).", path_.string(), std::strerror(reason));
}

VideoWriter::~VideoWriter() {
    wait();
    ::close(complaints_);
}

int VideoWriter::wait() {
    if (pipe_ >= 0) ::close(pipe_);
    pipe_ = -1;
    int status = 0;
    if (process_ > 0) {
        while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {
        }
    }
    process_ = -1;
    return status;
}

void VideoWriter::fail() {
    wait();
    const std::string reason = with_name(first_line(complaints_), part_, path_);
    throw core::InputError(
        "%1: ffmpeg cannot make the video (%2).", path_.string(),
        reason.empty() ? core::message("no reason given") : core::Message::verbatim(reason));
}

void VideoWriter::write(const pigment::Image8& frame) {
    PASTOSO_CHECK_OP(frame.width, ==, width_);
    PASTOSO_CHECK_OP(frame.height, ==, height_);
    for (std::size_t sent = 0; sent < frame.rgb.size();) {
        const ssize_t count = ::write(pipe_, frame.rgb.data() + sent, frame.rgb.size() - sent);
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) fail();
        sent += static_cast<std::size_t>(count);
    }
}

void VideoWriter::finish() {
    if (wait() != 0) fail();
}

}  // namespace pastoso::files
