#include "io/picture_export.hpp"

#include "core/error.hpp"
#include "core/text_file.hpp"
#include "io/image.hpp"
#include "io/surface_values.hpp"

#include <vector>

namespace pastoso::io {
namespace {

using grid::Rect;

ExportStatus status_of(bool written) {
    return written ? ExportStatus::Written : ExportStatus::Stopped;
}

std::vector<ImageChannel> channels_of(const std::string& layer) {
    std::vector<ImageChannel> channels = {{"R"}, {"G"}, {"B"}};
    for (const char* name : {"lit.R", "lit.G", "lit.B", "albedo.R", "albedo.G", "albedo.B", "normal.X",
                             "normal.Y", "normal.Z"})
        channels.push_back({layer + "." + name});
    channels.push_back({layer + ".height_mm.V", Sample::Single});
    channels.push_back({layer + ".wetness.V"});
    channels.push_back({layer + ".gloss.V"});
    return channels;
}

/// The values of a pixel in the order of channels_of().
void add_pixel(const float* lit, const shade::SurfaceSample& sample, const shade::Lighting& lighting,
               std::vector<float>& values) {
    for (int copies = 0; copies < 2; ++copies)
        values.insert(values.end(), lit, lit + 3);
    values.insert(values.end(), {sample.red, sample.green, sample.blue});
    const std::array<float, 3> normal = surface_normal(sample);
    values.insert(values.end(), normal.begin(), normal.end());
    values.insert(values.end(),
                  {sample.height_mm, sample.wetness, 1.0F - surface_roughness(sample, lighting)});
}

ImageLayout layers_layout(const ExportSource& source, const shade::Lattice& lattice,
                          const std::string& layer) {
    ImageLayout layout;
    layout.width = lattice.width;
    layout.height = lattice.height;
    layout.sample = Sample::Single;  // of the rows given; each channel names its own
    layout.channels = channels_of(layer);
    layout.channel_count = static_cast<int>(layout.channels.size());
    layout.px_per_mm = export_px_per_mm(source);
    layout.space = source.settings.viewing.space;
    layout.description = "Lengths are in millimetres.";
    return layout;
}

}  // namespace

ExportStatus export_picture(const std::filesystem::path& path, const ExportSource& source,
                            const PictureEncoding& encoding, core::ThreadPool& pool,
                            const KeepGoing& keep_going) {
    const shade::Lattice lattice = export_lattice(source);
    const ImageLayout layout =
        picture_layout(path, lattice.width, lattice.height, source.settings.viewing.space, encoding,
                       export_px_per_mm(source));
    const shade::Renderer renderer(source.film, source.ground, lattice, source.settings, pool);
    return status_of(core::write_aside_unless(path, [&](const std::filesystem::path& temporary) {
        ImageWriter writer(temporary, path, layout);
        shade::LinearImage rows;
        const bool complete = for_each_band(lattice, keep_going, [&](const Rect& pixels) {
            renderer.render(pixels, &rows, nullptr);
            write_picture_rows(writer, layout, rows);
        });
        if (complete) writer.finish();
        return complete;
    }));
}

ExportStatus export_layers(const std::filesystem::path& path, const ExportSource& source,
                           const std::string& layer, core::ThreadPool& pool,
                           const KeepGoing& keep_going) {
    if (!is_linear_format(path)) {
        throw core::InputError(path.string() +
                               ": only .exr files hold the layers' heights and normals.");
    }
    const shade::Lattice lattice = export_lattice(source);
    const ImageLayout layout = layers_layout(source, lattice, layer);
    const shade::Renderer renderer(source.film, source.ground, lattice, source.settings, pool);
    return status_of(core::write_aside_unless(path, [&](const std::filesystem::path& temporary) {
        ImageWriter writer(temporary, path, layout);
        shade::LinearImage lit;
        shade::SurfaceSamples surface;
        std::vector<float> values;
        const bool complete = for_each_band(lattice, keep_going, [&](const Rect& pixels) {
            renderer.render(pixels, &lit, &surface);
            values.clear();
            for (std::size_t i = 0; i < surface.samples.size(); ++i)
                add_pixel(&lit.rgb[3 * i], surface.samples[i], source.settings.lighting, values);
            writer.write_rows(values.data(), lit.height);
        });
        if (complete) writer.finish();
        return complete;
    }));
}

}  // namespace pastoso::io
