#include "files/triangle_readers.hpp"

#include <array>
#include <cstdint>
#include <cstring>
#include <sstream>

#include <gtest/gtest.h>

namespace pastoso::files {
namespace {

using liquid::TriangleMesh;

template <class Value>
Value take(const char*& place) {
    Value value;
    std::memcpy(&value, place, sizeof value);
    place += sizeof value;
    return value;
}

glm::vec3 take_vector(const char*& place) {
    const auto x = take<float>(place), y = take<float>(place), z = take<float>(place);
    return {x, y, z};
}

/// "7", or "7//7" with a normal of the same number; the number counted from 0.
std::uint32_t read_corner(std::istream& words) {
    std::uint32_t vertex = 0;
    words >> vertex;
    if (words.peek() == '/') {
        std::uint32_t normal = 0;
        words.ignore(2) >> normal;
        EXPECT_EQ(normal, vertex);
    }
    return vertex - 1;
}

}  // namespace

TriangleMesh read_ply(const std::string& file) {
    std::istringstream header(file.substr(0, file.find("end_header")));
    std::size_t counts[2] = {}, next = 0;
    for (std::string word; header >> word;)
        if (word == "element") header >> word >> counts[next++];
    const bool normals = header.str().find("property float nx") != std::string::npos;
    const char* place = file.data() + file.find("end_header\n") + 11;
    TriangleMesh mesh;
    for (std::size_t i = 0; i < counts[0]; ++i) {
        mesh.positions_m.push_back(take_vector(place));
        if (normals) mesh.normals.push_back(take_vector(place));
    }
    for (std::size_t i = 0; i < counts[1]; ++i) {
        EXPECT_EQ(take<std::uint8_t>(place), 3);
        mesh.triangles.push_back(take<std::array<std::uint32_t, 3>>(place));
    }
    EXPECT_EQ(place, file.data() + file.size());
    return mesh;
}

TriangleMesh read_stl(const std::string& file) {
    const char* place = file.data() + 80;
    const auto count = take<std::uint32_t>(place);
    EXPECT_EQ(file.size(), 84 + 50 * std::size_t{count});
    TriangleMesh mesh;
    for (std::uint32_t i = 0; i < count; ++i) {
        mesh.normals.insert(mesh.normals.end(), 3, take_vector(place));
        for (int corner = 0; corner < 3; ++corner)
            mesh.positions_m.push_back(take_vector(place));
        mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
        place += 2;
    }
    return mesh;
}

TriangleMesh read_obj(const std::string& file) {
    std::istringstream lines(file);
    TriangleMesh mesh;
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string kind;
        words >> kind;
        if (kind == "v" || kind == "vn") {
            glm::vec3 vector;
            words >> vector.x >> vector.y >> vector.z;
            (kind == "v" ? mesh.positions_m : mesh.normals).push_back(vector);
        }
        if (kind != "f") continue;
        std::array<std::uint32_t, 3> triangle;
        for (std::uint32_t& vertex : triangle)
            vertex = read_corner(words);
        mesh.triangles.push_back(triangle);
    }
    return mesh;
}

}  // namespace pastoso::files
