// Triangles without shared corners, in bytes or as a text.
#include "core/error.hpp"
#include "core/text.hpp"
#include "files/text_lines.hpp"
#include "liquid_files/mesh_import.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace pastoso::liquid_files {
namespace {

static_assert(std::endian::native == std::endian::little, "STL is read as little endian");

constexpr std::size_t kCountAt = 80, kHeadBytes = 84, kTriangleBytes = 50, kVectorBytes = 12;

[[noreturn]] void fail_at_byte(const std::string& name, std::size_t byte, const core::Message& message) {
    throw core::InputError("%1, byte %2: %3", name, byte, message);
}

[[noreturn]] void fail_as_too_many(const std::string& name) {
    throw core::InputError("%1: there are more than %2 triangles.", name, kMostMeshTriangles);
}

/// Three of them make a triangle.
using Corners = std::vector<glm::vec3>;

/// For each corner the first one at the same place.
std::vector<std::uint32_t> first_at_same_place(const Corners& corners) {
    std::vector<std::uint32_t> order(corners.size());
    std::iota(order.begin(), order.end(), 0U);
    const auto key = [&](std::uint32_t n) {
        return std::tuple(corners[n].x, corners[n].y, corners[n].z, n);
    };
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
    std::vector<std::uint32_t> first(corners.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool same = i > 0 && corners[order[i]] == corners[order[i - 1]];
        first[order[i]] = same ? first[order[i - 1]] : order[i];
    }
    return first;
}

/// Vertices in the order of their first corners.
liquid::TriangleMesh welded(const Corners& corners) {
    const std::vector<std::uint32_t> first = first_at_same_place(corners);
    std::vector<std::uint32_t> vertex_of(corners.size());
    liquid::TriangleMesh mesh;
    for (std::uint32_t n = 0; n < corners.size(); ++n) {
        if (first[n] == n) {
            vertex_of[n] = static_cast<std::uint32_t>(mesh.positions_m.size());
            mesh.positions_m.push_back(corners[n]);
        } else {
            vertex_of[n] = vertex_of[first[n]];
        }
    }
    for (std::size_t n = 0; n < corners.size(); n += 3) {
        const std::uint32_t a = vertex_of[n], b = vertex_of[n + 1], c = vertex_of[n + 2];
        if (a != b && b != c && c != a) mesh.triangles.push_back({a, b, c});
    }
    return mesh;
}

std::size_t binary_bytes(std::uint32_t triangles) {
    return kHeadBytes + kTriangleBytes * std::size_t{triangles};
}

std::uint32_t binary_count(std::string_view bytes) {
    std::uint32_t count = 0;
    std::memcpy(&count, bytes.data() + kCountAt, sizeof count);
    return count;
}

Corners read_binary(std::string_view bytes, const std::string& name) {
    const std::uint32_t count = binary_count(bytes);
    if (count > kMostMeshTriangles) fail_as_too_many(name);
    Corners corners;
    corners.reserve(std::size_t{3} * count);
    for (std::size_t triangle = 0; triangle < count; ++triangle) {
        // A normal stands before the corners.
        const std::size_t begin = kHeadBytes + kTriangleBytes * triangle + kVectorBytes;
        for (std::size_t at = begin; at < begin + 3 * kVectorBytes; at += kVectorBytes) {
            float numbers[3];
            std::memcpy(numbers, bytes.data() + at, sizeof numbers);
            for (const float number : numbers)
                if (!std::isfinite(number))
                    fail_at_byte(name, at,
                                 core::message("a corner of triangle %1 is not finite (%2).", triangle,
                                               std::to_string(number)));
            corners.emplace_back(numbers[0], numbers[1], numbers[2]);
        }
    }
    return corners;
}

class StlText {
  public:
    StlText(std::string_view text, const std::string& name) : lines_(text, name), name_(name) {}

    Corners read() {
        while (lines_.next()) {
            const std::string_view word = lines_.word();
            if (!word.empty()) take(word);
        }
        if (in_solid_ || in_loop_ != kNoLoop) lines_.fail("the file ends here, before \"endsolid\".");
        return std::move(corners_);
    }

  private:
    static constexpr int kNoLoop = -1;

    void take(std::string_view word) {
        const std::string kind = core::lower_case(word);
        if (kind == "vertex") return add_vertex();
        if (kind == "solid" || kind == "endsolid") {
            if (in_loop_ != kNoLoop)
                lines_.fail("\"endloop\" is missing before %1.", files::quoted(word));
            in_solid_ = kind == "solid";
        } else if (kind == "outer") {
            if (in_loop_ != kNoLoop) lines_.fail("a loop begins within another one.");
            in_loop_ = 0;
        } else if (kind == "endloop") {
            if (in_loop_ != 3) lines_.fail("a loop ends that has no three corners.");
            in_loop_ = kNoLoop;
        } else if (kind != "facet" && kind != "endfacet") {
            lines_.fail("%1 does not belong in an STL file.", files::quoted(word));
        }
    }

    void add_vertex() {
        if (in_loop_ == kNoLoop) lines_.fail("a corner stands outside of a loop.");
        if (++in_loop_ > 3) lines_.fail("a triangle has more than three corners.");
        if (corners_.size() >= 3 * kMostMeshTriangles) fail_as_too_many(name_);
        const float x = lines_.number(), y = lines_.number(), z = lines_.number();
        corners_.emplace_back(x, y, z);
    }

    files::TextLines lines_;
    const std::string& name_;
    Corners corners_;
    bool in_solid_ = false;
    int in_loop_ = kNoLoop;  ///< corners of the loop so far
};

}  // namespace

liquid::TriangleMesh mesh_from_stl(std::string_view bytes, const std::string& name) {
    const bool has_head = bytes.size() >= kHeadBytes;
    if (has_head && bytes.size() == binary_bytes(binary_count(bytes)))
        return welded(read_binary(bytes, name));
    if (core::lower_case(bytes.substr(0, 5)) == "solid") return welded(StlText(bytes, name).read());
    if (!has_head)
        fail_at_byte(name, bytes.size(),
                     core::message("the file ends here, within the head of an STL file."));
    const std::uint32_t count = binary_count(bytes);
    fail_at_byte(name, kCountAt,
                 core::message("%1 triangles take %2 bytes, but the file has %3.", count,
                               binary_bytes(count), bytes.size()));
}

}  // namespace pastoso::liquid_files
