#include "recordings/layer_export.hpp"

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "files/image_writer.hpp"
#include "layers/apart.hpp"
#include "recordings/channel_names.hpp"
#include "recordings/picture_export.hpp"
#include "recordings/surface_values.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace pastoso::recordings {
namespace {

using film::FilmState;
using grid::Rect;

/// R, G, B and the support's height, and what each layer has.
constexpr std::size_t kSharedChannels = 4, kLayerChannels = 13;

/// Of the values of a band: less than the cells and pixels that are rendered for them.
constexpr double kBandValues = 15.0 * kBandPixels;

void add_layer_channels(const std::string& layer, std::vector<files::ImageChannel>& channels) {
    for (const char* name : {".lit.R", ".lit.G", ".lit.B", ".albedo.R", ".albedo.G", ".albedo.B",
                             ".normal.X", ".normal.Y", ".normal.Z"})
        channels.push_back({layer + name});
    channels.push_back({layer + ".height_mm.V", files::Sample::Single});
    for (const char* name : {".wetness.V", ".gloss.V", ".cover.A"})
        channels.push_back({layer + name});
}

files::ImageLayout layout_of(const ExportSource& source, const shade::Lattice& lattice,
                             const ChannelLayers& layers) {
    files::ImageLayout layout;
    layout.width = lattice.width;
    layout.height = lattice.height;
    layout.sample = files::Sample::Single;  // of the rows given; each channel names its own
    layout.channels = {{"R"}, {"G"}, {"B"}};
    layout.channels.push_back({std::string(kSupportChannels) + ".height_mm.V", files::Sample::Single});
    for (const ChannelLayer& layer : layers.layers)
        add_layer_channels(layer.name, layout.channels);
    layout.channel_count = static_cast<int>(layout.channels.size());
    layout.px_per_mm = export_px_per_mm(source);
    layout.space = source.settings.viewing.space;
    layout.description = "Lengths are in millimetres. " + layers.description;
    return layout;
}

/// The cells below a pixel, along one side.
struct CellSpan {
    int first, end;
};

CellSpan cells_below(int pixel, double begin_cells, double scale, int cells) {
    const int first = std::clamp(static_cast<int>(begin_cells + pixel / scale), 0, cells - 1);
    const int end = static_cast<int>(std::ceil(begin_cells + (pixel + 1) / scale));
    return {first, std::clamp(end, first + 1, cells)};
}

float cover_of(const FilmState& apart, const CellSpan& columns, const CellSpan& rows) {
    int covered = 0;
    for (int y = rows.first; y < rows.end; ++y)
        for (int x = columns.first; x < columns.end; ++x)
            covered += layers::holds_paint(apart, x, y) ? 1 : 0;
    const int all = (columns.end - columns.first) * (rows.end - rows.first);
    return static_cast<float>(covered) / static_cast<float>(all);
}

FilmState on_support(const FilmState& apart, const ChannelLayers& layers) {
    return layers::laid_on(apart, layers.bare_mm);
}

FilmState bare_support(const FilmState& canvas, const ChannelLayers& layers) {
    FilmState bare(canvas.shape, canvas.cell_mm);
    bare.support_mm = layers.bare_mm;
    return bare;
}

/// One film and what renders it: a renderer needs its film to outlive it.
struct Rendered {
    Rendered(FilmState state, const ExportSource& source, const shade::Lattice& lattice,
             core::ThreadPool& pool)
        : film(std::move(state)), renderer(film, source.ground, lattice, source.settings, pool) {}
    Rendered(const Rendered&) = delete;
    Rendered& operator=(const Rendered&) = delete;

    const FilmState film;
    const shade::Renderer renderer;
};

/// Puts the values of all channels of a band together.
class BandValues {
  public:
    BandValues(const ExportSource& source, const ChannelLayers& layers, const shade::Lattice& lattice,
               core::ThreadPool& pool)
        : source_(source),
          layers_(layers),
          lattice_(lattice),
          pool_(pool),
          stride_(kSharedChannels + kLayerChannels * layers.layers.size()),
          picture_(source.film, source.ground, lattice, source.settings, pool),
          support_(bare_support(source.film, layers), source, lattice, pool) {
        for (const ChannelLayer& layer : layers.layers)
            rendered_.push_back(
                std::make_unique<Rendered>(on_support(*layer.film, layers), source, lattice, pool));
    }

    double most_pixels() const { return kBandValues / static_cast<double>(stride_); }

    const std::vector<float>& values_of(const Rect& pixels) {
        const auto count =
            static_cast<std::size_t>(pixels.width()) * static_cast<std::size_t>(pixels.height());
        values_.resize(count * stride_);
        render_picture(picture_, source_, pixels, &lit_);
        support_.renderer.render(pixels, nullptr, &surface_);
        for (std::size_t i = 0; i < count; ++i) {
            std::copy_n(&lit_.rgb[3 * i], 3, &values_[stride_ * i]);
            values_[stride_ * i + 3] = surface_.samples[i].height_mm;
        }
        for (std::size_t layer = 0; layer < rendered_.size(); ++layer)
            add_layer(layer, pixels);
        return values_;
    }

  private:
    void add_layer(std::size_t layer, const Rect& pixels) {
        rendered_[layer]->renderer.render(pixels, &lit_, &surface_);
        const FilmState& apart = *layers_.layers[layer].film;
        const auto width = static_cast<std::size_t>(pixels.width());
        pool_.run(static_cast<std::size_t>(pixels.height()), [&](std::size_t row, int) {
            const CellSpan rows = cells_below(pixels.y0 + static_cast<int>(row), lattice_.top_cells,
                                              lattice_.scale_y, apart.shape.height);
            for (std::size_t column = 0; column < width; ++column) {
                const CellSpan columns =
                    cells_below(pixels.x0 + static_cast<int>(column), lattice_.left_cells,
                                lattice_.scale_x, apart.shape.width);
                const std::size_t pixel = row * width + column;
                write_pixel(pixel, cover_of(apart, columns, rows),
                            &values_[stride_ * pixel + kSharedChannels + kLayerChannels * layer]);
            }
        });
    }

    /// In the order of add_layer_channels().
    void write_pixel(std::size_t pixel, float cover, float* values) const {
        const shade::SurfaceSample& sample = surface_.samples[pixel];
        const std::array<float, 3> normal = surface_normal(sample);
        values = std::copy_n(&lit_.rgb[3 * pixel], 3, values);
        for (const float value :
             {sample.red, sample.green, sample.blue, normal[0], normal[1], normal[2], sample.height_mm,
              sample.wetness, 1.0F - surface_roughness(sample, source_.settings.lighting), cover})
            *values++ = value;
    }

    const ExportSource& source_;
    const ChannelLayers& layers_;
    const shade::Lattice& lattice_;
    core::ThreadPool& pool_;
    std::size_t stride_;  ///< values of a pixel
    shade::Renderer picture_;
    Rendered support_;
    std::vector<std::unique_ptr<Rendered>> rendered_;
    pigment::LinearImage lit_;
    shade::SurfaceSamples surface_;
    std::vector<float> values_;
};

std::string remarks_of(const document::LayerLook& look) {
    std::string remarks;
    if (look.opacity < 1.0) remarks += ", opacity " + core::number_text(look.opacity);
    if (!look.visible) remarks += ", hidden";
    if (look.clipped) remarks += ", clipped";
    return remarks;
}

}  // namespace

ChannelLayers channel_layers(const FilmState& film, const film::SupportHeights& bare_mm,
                             const document::LayerStack& stack) {
    ChannelLayers result{bare_mm, {}, "Layers from below:"};
    const document::LayerFilms films =
        document::shown_layers(document::layers_apart(film, bare_mm, stack), stack);
    std::vector<std::string> names;
    for (const document::Layer& layer : stack.layers)
        names.push_back(layer.look.name);
    const std::vector<std::string> safe = channel_names(names);
    for (std::size_t place = 0; place < films.size(); ++place) {
        result.layers.push_back({safe[place], films[place]});
        result.description += (place == 0 ? " " : "; ") + safe[place] + " is \"" + names[place] + "\"" +
                              remarks_of(document::effective_look(stack, place));
    }
    result.description += ".";
    return result;
}

files::ExportStatus export_layers(const std::filesystem::path& path, const ExportSource& source,
                                  const ChannelLayers& layers, core::ThreadPool& pool,
                                  const files::KeepGoing& keep_going) {
    if (!files::is_linear_format(path)) {
        throw core::InputError("%1: only .exr files hold the layers' heights and normals.",
                               path.string());
    }
    const shade::Lattice lattice = export_lattice(source);
    const files::ImageLayout layout = layout_of(source, lattice, layers);
    BandValues band(source, layers, lattice, pool);
    const bool written = core::write_aside_unless(path, [&](core::OutputFile& file) {
        files::ImageWriter writer(file, layout);
        const bool complete = for_each_band(
            lattice, keep_going,
            [&](const Rect& pixels) {
                writer.write_rows(band.values_of(pixels).data(), pixels.height());
            },
            band.most_pixels());
        if (complete) writer.finish();
        return complete;
    });
    return written ? files::ExportStatus::Written : files::ExportStatus::Stopped;
}

}  // namespace pastoso::recordings
