// Files of triangles: .stl (binary), .ply (binary, little endian) and .obj, written in pieces.
#pragma once

#include "files/keep_going.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

namespace pastoso::files {

using Triangle = std::array<std::uint32_t, 3>;  ///< vertices, counter-clockwise seen from outside
using Vector = std::array<float, 3>;

/// What is written: z up.
class TriangleSource {
  public:
    virtual ~TriangleSource() = default;
    virtual std::string title() const = 0;  ///< "relief, millimetres": what it is, and its unit
    virtual std::size_t vertex_count() const = 0;
    virtual std::size_t triangle_count() const = 0;
    virtual Vector vertex(std::size_t index) const = 0;
    virtual bool has_normals() const { return false; }
    virtual Vector normal(std::size_t) const { return {}; }
    virtual void for_each_triangle(const std::function<void(const Triangle&)>& use) const = 0;
};

/// The upward axis of an .obj file, which the format leaves open: z as in the others, or y, as most
/// programs that read such files expect, (x, y, z) becoming (x, z, -y).
enum class ObjUp { Z, Y };

/// Whether a file's name ends in .stl, .ply or .obj, in letters of any case.
bool is_triangle_path(const std::filesystem::path& path);

/// Writes the file aside; the name must be one that is_triangle_path() accepts. Throws InputError when
/// it cannot be written. A source without triangles makes a valid file without any.
ExportStatus write_triangles(const std::filesystem::path& path, const TriangleSource& source,
                             ObjUp obj_up, const KeepGoing& keep_going);

}  // namespace pastoso::files
