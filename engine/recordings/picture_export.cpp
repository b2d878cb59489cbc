#include "recordings/picture_export.hpp"

#include "recordings/surface_values.hpp"
#include "shade/picture_sheet.hpp"

#include <algorithm>

namespace pastoso::recordings {

void render_picture(const shade::Renderer& renderer, const ExportSource& source,
                    const grid::Rect& pixels, pigment::LinearImage* picture) {
    if (source.lit) return renderer.render(pixels, picture, nullptr);
    shade::SurfaceSamples surface;
    renderer.render(pixels, nullptr, &surface);
    *picture = surface_colours(surface, source.settings.viewing.space);
}

pigment::LinearImage frame_picture(ExportSource source, const grid::Shape& first,
                                   core::ThreadPool& pool) {
    const grid::Shape shape = source.film.shape;
    const shade::Lattice frame = shade::picture_lattice(first, first.cells(), source.settings.scale);
    if (shape != first)
        source.settings.scale = std::min(static_cast<double>(frame.width) / shape.width,
                                         static_cast<double>(frame.height) / shape.height);
    const shade::Lattice lattice = export_lattice(source);
    const shade::Renderer renderer(source.film, source.ground, lattice, source.settings, pool);
    pigment::LinearImage picture;
    render_picture(renderer, source, {0, 0, lattice.width, lattice.height}, &picture);
    return shape == first ? picture : shade::framed(picture, frame.width, frame.height);
}

files::ExportStatus export_picture(const std::filesystem::path& path, const ExportSource& source,
                                   const files::PictureEncoding& encoding, core::ThreadPool& pool,
                                   const files::KeepGoing& keep_going, const BandViewer& view) {
    const shade::Lattice lattice = export_lattice(source);
    const files::ImageLayout layout =
        files::picture_layout(path, lattice.width, lattice.height, source.settings.viewing.space,
                              encoding, export_px_per_mm(source));
    const shade::Renderer renderer(source.film, source.ground, lattice, source.settings, pool);
    const bool written = core::write_aside_unless(path, [&](core::OutputFile& file) {
        files::ImageWriter writer(file, layout);
        pigment::LinearImage rows;
        const bool complete = for_each_band(lattice, keep_going, [&](const grid::Rect& pixels) {
            render_picture(renderer, source, pixels, &rows);
            view(rows);
            files::write_picture_rows(writer, layout, rows);
        });
        if (complete) writer.finish();
        return complete;
    });
    return written ? files::ExportStatus::Written : files::ExportStatus::Stopped;
}

}  // namespace pastoso::recordings
