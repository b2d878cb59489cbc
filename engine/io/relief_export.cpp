#include "io/relief_export.hpp"

#include "core/error.hpp"

namespace pastoso::io {
namespace {

class ReliefSource : public TriangleSource {
  public:
    explicit ReliefSource(const Relief& relief) : relief_(relief) {}

    std::string title() const override { return "relief, millimetres"; }
    std::size_t vertex_count() const override { return relief_.vertex_count(); }
    std::size_t triangle_count() const override { return relief_.triangle_count(); }
    Vector vertex(std::size_t index) const override { return relief_.vertex(index); }
    void for_each_triangle(const std::function<void(const Triangle&)>& use) const override {
        io::for_each_triangle(relief_, use);
    }

  private:
    const Relief& relief_;
};

}  // namespace

bool is_relief_path(const std::filesystem::path& path) {
    return is_triangle_path(path);
}

ExportStatus export_relief(const std::filesystem::path& path, const Relief& relief,
                           const KeepGoing& keep_going) {
    if (!is_relief_path(path)) {
        throw core::InputError(path.string() +
                               ": a relief is saved as .stl, .ply or .obj; this name ends otherwise.");
    }
    return write_triangles(path, ReliefSource(relief), ObjUp::Z, keep_going);
}

}  // namespace pastoso::io
