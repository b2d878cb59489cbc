#include "files/triangle_file.hpp"

#include "core/check.hpp"
#include "core/number_text.hpp"
#include "core/text.hpp"
#include "files/piece_writer.hpp"

#include <bit>
#include <cmath>
#include <cstdio>

namespace pastoso::files {
namespace {

static_assert(std::endian::native == std::endian::little, "STL and PLY are written in little endian");

/// What a file gets of a source.
struct Job {
    const TriangleSource& source;
    ObjUp obj_up;
};

/// A unit vector; zeros for a triangle without area, which readers replace.
Vector normal_of(const Vector& a, const Vector& b, const Vector& c) {
    const Vector u = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
    const Vector v = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};
    const Vector n = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    const float length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    if (length == 0.0F) return {};
    return {n[0] / length, n[1] / length, n[2] / length};
}

void write_stl(const Job& job, PieceWriter& writer) {
    std::string header = "Pastoso " + job.source.title();
    header.insert(header.find(','), ", binary STL");
    header.resize(80, ' ');
    writer.add_text(header);
    writer.add(static_cast<std::uint32_t>(job.source.triangle_count()));
    job.source.for_each_triangle([&](const Triangle& triangle) {
        const Vector a = job.source.vertex(triangle[0]), b = job.source.vertex(triangle[1]),
                     c = job.source.vertex(triangle[2]);
        for (const Vector& vector : {normal_of(a, b, c), a, b, c})
            writer.add(vector);
        writer.add(std::uint16_t{0});
        writer.item_done();
    });
}

std::string ply_header(const TriangleSource& source) {
    const char* normals =
        source.has_normals() ? "property float nx\nproperty float ny\nproperty float nz\n" : "";
    return "ply\nformat binary_little_endian 1.0\ncomment Pastoso " + source.title() +
           "\nelement vertex " + std::to_string(source.vertex_count()) +
           "\nproperty float x\nproperty float y\nproperty float z\n" + normals + "element face " +
           std::to_string(source.triangle_count()) +
           "\nproperty list uchar int vertex_indices\nend_header\n";
}

void write_ply(const Job& job, PieceWriter& writer) {
    writer.add_text(ply_header(job.source));
    for (std::size_t i = 0; i < job.source.vertex_count(); ++i) {
        writer.add(job.source.vertex(i));
        if (job.source.has_normals()) writer.add(job.source.normal(i));
        writer.item_done();
    }
    job.source.for_each_triangle([&](const Triangle& triangle) {
        writer.add(std::uint8_t{3});
        writer.add(triangle);
        writer.item_done();
    });
}

void add_obj_vector(const char* kind, const Vector& vector, ObjUp up, PieceWriter& writer) {
    const auto [x, y, z] = up == ObjUp::Z ? vector : Vector{vector[0], vector[2], -vector[1]};
    std::string line = kind;
    for (const float value : {x, y, z})
        line += ' ' + core::number_text(static_cast<double>(value), 9);
    writer.add_text(line + '\n');
}

void write_obj(const Job& job, PieceWriter& writer) {
    const TriangleSource& source = job.source;
    writer.add_text("# Pastoso " + source.title() + "\n");
    for (std::size_t i = 0; i < source.vertex_count(); ++i) {
        add_obj_vector("v", source.vertex(i), job.obj_up, writer);
        if (source.has_normals()) add_obj_vector("vn", source.normal(i), job.obj_up, writer);
        writer.item_done();
    }
    const bool normals = source.has_normals();
    source.for_each_triangle([&](const Triangle& triangle) {
        char line[96];
        const std::uint32_t a = triangle[0] + 1, b = triangle[1] + 1, c = triangle[2] + 1;
        if (normals)
            std::snprintf(line, sizeof line, "f %u//%u %u//%u %u//%u\n", a, a, b, b, c, c);
        else
            std::snprintf(line, sizeof line, "f %u %u %u\n", a, b, c);
        writer.add_text(line);
        writer.item_done();
    });
}

struct Format {
    const char* extension;
    bool has_vertices;
    void (*write)(const Job& job, PieceWriter& writer);
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

bool is_triangle_path(const std::filesystem::path& path) {
    return format_of(path) != nullptr;
}

ExportStatus write_triangles(const std::filesystem::path& path, const TriangleSource& source,
                             ObjUp obj_up, const KeepGoing& keep_going) {
    const Format* format = format_of(path);
    PASTOSO_CHECK(format != nullptr);
    const std::size_t items =
        source.triangle_count() + (format->has_vertices ? source.vertex_count() : 0);
    return write_in_pieces(path, items, keep_going, [&](PieceWriter& writer) {
        format->write({source, obj_up}, writer);
    });
}

}  // namespace pastoso::files
