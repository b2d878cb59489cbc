#include "io/relief_export.hpp"

#include "core/error.hpp"
#include "core/text.hpp"
#include "core/text_file.hpp"

#include <bit>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <string>

namespace pastoso::io {
namespace {

static_assert(std::endian::native == std::endian::little, "STL and PLY are written in little endian");

struct Stopped {};

/// A file that is written in large pieces, and its progress.
class Sink {
  public:
    Sink(const std::filesystem::path& file, std::size_t items, const KeepGoing& keep_going)
        : stream_(file, std::ios::binary), items_(items), keep_going_(keep_going) {}

    template <class Value>
    void add(const Value& value) {
        buffer_.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
    void add_text(const std::string& text) { buffer_ += text; }

    /// After every vertex and triangle; throws Stopped.
    void item_done() {
        ++done_;
        if (buffer_.size() < kPiece) return;
        flush();
        if (!keep_going_(static_cast<double>(done_) / static_cast<double>(items_))) throw Stopped{};
    }

    bool finish() {
        flush();
        stream_.flush();
        return static_cast<bool>(stream_);
    }

  private:
    static constexpr std::size_t kPiece = std::size_t{1} << 20;

    void flush() {
        stream_.write(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
        buffer_.clear();
    }

    std::ofstream stream_;
    std::string buffer_;
    std::size_t items_, done_ = 0;
    const KeepGoing& keep_going_;
};

using Vector = std::array<float, 3>;

Vector normal_of(const Vector& a, const Vector& b, const Vector& c) {
    const Vector u = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
    const Vector v = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};
    const Vector n = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    const float length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    return {n[0] / length, n[1] / length, n[2] / length};
}

void write_stl(const Relief& relief, Sink& sink) {
    std::string header = "Pastoso relief, binary STL, millimetres";
    header.resize(80, ' ');
    sink.add_text(header);
    sink.add(static_cast<std::uint32_t>(relief.triangle_count()));
    for_each_triangle(relief, [&](const Triangle& triangle) {
        const Vector a = relief.vertex(triangle[0]), b = relief.vertex(triangle[1]),
                     c = relief.vertex(triangle[2]);
        for (const Vector& vector : {normal_of(a, b, c), a, b, c})
            sink.add(vector);
        sink.add(std::uint16_t{0});
        sink.item_done();
    });
}

void write_ply(const Relief& relief, Sink& sink) {
    sink.add_text(
        "ply\nformat binary_little_endian 1.0\ncomment Pastoso relief, millimetres\n"
        "element vertex " +
        std::to_string(relief.vertex_count()) +
        "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
        std::to_string(relief.triangle_count()) +
        "\nproperty list uchar int vertex_indices\nend_header\n");
    for (std::size_t i = 0; i < relief.vertex_count(); ++i) {
        sink.add(relief.vertex(i));
        sink.item_done();
    }
    for_each_triangle(relief, [&](const Triangle& triangle) {
        sink.add(std::uint8_t{3});
        sink.add(triangle);
        sink.item_done();
    });
}

void write_obj(const Relief& relief, Sink& sink) {
    char line[96];
    sink.add_text("# Pastoso relief, millimetres\n");
    for (std::size_t i = 0; i < relief.vertex_count(); ++i) {
        const auto [x, y, z] = relief.vertex(i);
        std::snprintf(line, sizeof line, "v %.9g %.9g %.9g\n", static_cast<double>(x),
                      static_cast<double>(y), static_cast<double>(z));
        sink.add_text(line);
        sink.item_done();
    }
    for_each_triangle(relief, [&](const Triangle& triangle) {
        std::snprintf(line, sizeof line, "f %u %u %u\n", triangle[0] + 1, triangle[1] + 1,
                      triangle[2] + 1);
        sink.add_text(line);
        sink.item_done();
    });
}

struct Format {
    const char* extension;
    bool has_vertices;
    void (*write)(const Relief& relief, Sink& sink);
};
constexpr Format kFormats[] = {
    {".stl", false, write_stl}, {".ply", true, write_ply}, {".obj", true, write_obj}};

const Format* format_of(const std::filesystem::path& path) {
    const std::string extension = core::lower_case(path.extension().string());
    for (const Format& format : kFormats) {
        if (extension == format.extension) return &format;
    }
    return nullptr;
}

}  // namespace

bool is_relief_path(const std::filesystem::path& path) {
    return format_of(path) != nullptr;
}

ExportStatus export_relief(const std::filesystem::path& path, const Relief& relief,
                           const KeepGoing& keep_going) {
    const Format* format = format_of(path);
    if (format == nullptr) {
        throw core::InputError(path.string() +
                               ": a relief is saved as .stl, .ply or .obj; this name ends otherwise.");
    }
    const std::size_t items =
        relief.triangle_count() + (format->has_vertices ? relief.vertex_count() : 0);
    const bool written = core::write_aside_unless(path, [&](const std::filesystem::path& temporary) {
        Sink sink(temporary, items, keep_going);
        try {
            format->write(relief, sink);
        } catch (const Stopped&) {
            return false;
        }
        if (!sink.finish())
            throw core::InputError(path.string() + ": cannot be written (the disk may be full).");
        return keep_going(1.0);
    });
    return written ? ExportStatus::Written : ExportStatus::Stopped;
}

}  // namespace pastoso::io
