// Shapes in JSON (docs/tank-format.md): an object with one entry, the form.
#pragma once

#include "files/json_place.hpp"
#include "tank/shape.hpp"

#include <functional>
#include <memory>
#include <string>

namespace pastoso::liquid_files {

/// The mesh of a file that a scene names. Throws InputError when it cannot be read.
using MeshOfFile = std::function<std::shared_ptr<const liquid::TriangleMesh>(const std::string& file)>;

/// A shape that tank::check_shape() accepts.
tank::Shape read_shape(const files::JsonPlace& place, const MeshOfFile& mesh_of);

/// read_shape() gives it back exactly, given the same meshes.
files::Json shape_to_json(const tank::Shape& shape);

/// Three numbers, by axis.
glm::vec3 read_vector(const files::JsonPlace& place);
files::Json vector_to_json(const glm::vec3& vector);

/// With no more digits than it takes to be read as the same float.
files::Json float_to_json(float value);

}  // namespace pastoso::liquid_files
