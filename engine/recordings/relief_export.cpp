#include "recordings/relief_export.hpp"

#include "core/error.hpp"

namespace pastoso::recordings {
namespace {

class ReliefSource : public files::TriangleSource {
  public:
    explicit ReliefSource(const Relief& relief) : relief_(relief) {}

    std::string title() const override { return "relief, millimetres"; }
    std::size_t vertex_count() const override { return relief_.vertex_count(); }
    std::size_t triangle_count() const override { return relief_.triangle_count(); }
    files::Vector vertex(std::size_t index) const override { return relief_.vertex(index); }
    void for_each_triangle(const std::function<void(const files::Triangle&)>& use) const override {
        recordings::for_each_triangle(relief_, use);
    }

  private:
    const Relief& relief_;
};

}  // namespace

bool is_relief_path(const std::filesystem::path& path) {
    return files::is_triangle_path(path);
}

files::ExportStatus export_relief(const std::filesystem::path& path, const Relief& relief,
                                  const files::KeepGoing& keep_going) {
    if (!is_relief_path(path)) {
        throw core::InputError("%1: a relief is saved as .stl, .ply or .obj; this name ends otherwise.",
                               path.string());
    }
    return files::write_triangles(path, ReliefSource(relief), files::ObjUp::Z, keep_going);
}

}  // namespace pastoso::recordings
