#include "recordings/map_export.hpp"

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "files/image.hpp"
#include "recordings/surface_values.hpp"
#include "shade/surface.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

namespace pastoso::recordings {
namespace {

using core::number_text;
using grid::Rect;
using Path = std::filesystem::path;

enum Map { kBaseColour, kNormal, kHeight, kRoughness, kMapCount };
constexpr const char* kSuffixes[kMapCount] = {"-basecolor", "-normal", "-height", "-roughness"};

bool is_integer(files::Sample sample) {
    return sample == files::Sample::Uint8 || sample == files::Sample::Uint16;
}

std::string range_text(const MapHeights& heights) {
    return "Height: 0 is " + number_text(heights.black_mm) + " mm, 65535 is " +
           number_text(heights.white_mm) + " mm.";
}

/// Heights are kept more finely than colours.
files::Sample height_sample(files::Sample colours) {
    return is_integer(colours) ? files::Sample::Uint16 : files::Sample::Single;
}

files::ImageLayout data_layout(const files::ImageLayout& colours, int map, const MapHeights& heights) {
    files::ImageLayout layout = colours;
    layout.holds_colours = false;
    layout.profile.clear();
    layout.channel_count = map == kNormal ? 3 : 1;
    if (map != kHeight) return layout;
    layout.sample = height_sample(colours.sample);
    layout.description =
        layout.sample == files::Sample::Single ? "Height in millimetres." : range_text(heights);
    return layout;
}

/// The values of a map's pixel, 0 to 1 but for heights in millimetres.
void add_values(int map, const shade::SurfaceSample& sample, const shade::Lighting& lighting,
                std::vector<float>& values) {
    if (map == kHeight) values.push_back(sample.height_mm);
    if (map == kRoughness) values.push_back(surface_roughness(sample, lighting));
    if (map != kNormal) return;
    for (const float component : surface_normal(sample))
        values.push_back(0.5F + 0.5F * component);
}

template <class Integer>
std::vector<Integer> in_steps(const std::vector<float>& values, float black, float white) {
    const float steps = sizeof(Integer) == 1 ? 255.0F : 65535.0F;
    std::vector<Integer> result;
    result.reserve(values.size());
    for (const float value : values) {
        const float share = std::clamp((value - black) / (white - black), 0.0F, 1.0F);
        result.push_back(static_cast<Integer>(std::lround(share * steps)));
    }
    return result;
}

/// The four files while they are written.
class MapWriter {
  public:
    MapWriter(const std::vector<Path>& paths, const files::ImageLayout& colours, const MapHeights& heights,
              const shade::Lighting& lighting)
        : heights_(heights), lighting_(lighting) {
        for (int map = 0; map < kMapCount; ++map) {
            layouts_.push_back(map == kBaseColour ? colours : data_layout(colours, map, heights));
            files_.push_back(std::make_unique<core::OutputFile>(paths[static_cast<std::size_t>(map)]));
            writers_.push_back(std::make_unique<files::ImageWriter>(*files_.back(), layouts_.back()));
        }
    }

    void write(const shade::SurfaceSamples& surface) {
        files::write_picture_rows(*writers_[kBaseColour], layouts_[kBaseColour],
                                  surface_colours(surface, layouts_[kBaseColour].space));
        for (const int map : {kNormal, kHeight, kRoughness})
            write_data(map, surface);
    }

    /// They take their places after the last is complete.
    void finish() {
        for (const auto& writer : writers_)
            writer->finish();
        for (const auto& file : files_)
            file->put_in_place();
    }

  private:
    void write_data(int map, const shade::SurfaceSamples& surface) {
        values_.clear();
        for (const shade::SurfaceSample& sample : surface.samples)
            add_values(map, sample, lighting_, values_);
        const auto i = static_cast<std::size_t>(map);
        const files::Sample sample = layouts_[i].sample;
        const float black = map == kHeight ? static_cast<float>(heights_.black_mm) : 0.0F;
        const float white = map == kHeight ? static_cast<float>(heights_.white_mm) : 1.0F;
        if (sample == files::Sample::Uint8)
            writers_[i]->write_rows(in_steps<std::uint8_t>(values_, black, white).data(),
                                    surface.height);
        else if (sample == files::Sample::Uint16)
            writers_[i]->write_rows(in_steps<std::uint16_t>(values_, black, white).data(),
                                    surface.height);
        else
            writers_[i]->write_rows(values_.data(), surface.height);
    }

    MapHeights heights_;
    shade::Lighting lighting_;
    std::vector<files::ImageLayout> layouts_;
    std::vector<std::unique_ptr<core::OutputFile>> files_;
    std::vector<std::unique_ptr<files::ImageWriter>> writers_;
    std::vector<float> values_;
};

/// Between bounds of the surface, in whole micrometres.
MapHeights heights_of(const film::FilmState& film) {
    constexpr double kPerMm = 1000.0;
    const shade::HeightRange bounds = shade::surface_bounds(film);
    return {std::floor(bounds.lowest_mm * kPerMm) / kPerMm,
            (std::floor(bounds.highest_mm * kPerMm) + 1.0) / kPerMm};
}

}  // namespace

std::vector<Path> map_paths(const Path& path) {
    std::vector<Path> paths;
    for (const char* suffix : kSuffixes)
        paths.push_back(path.parent_path() /
                        (path.stem().string() + suffix + path.extension().string()));
    return paths;
}

void check_map_paths(const Path& path, const files::PictureEncoding& encoding) {
    if (!files::is_linear_format(path) && !files::holds(path, files::Sample::Uint16)) {
        throw core::InputError("%1: maps are saved as .png, .tif or .exr; %2 files do not hold heights.",
                               path.string(), path.extension().string());
    }
    for (const Path& map : map_paths(path))
        files::check_picture_path(map, encoding);
}

files::ExportStatus export_maps(const Path& path, const ExportSource& source,
                                const files::PictureEncoding& encoding, core::ThreadPool& pool,
                                const files::KeepGoing& keep_going, MapHeights* told) {
    check_map_paths(path, encoding);
    const shade::Lattice lattice = export_lattice(source);
    const std::vector<Path> paths = map_paths(path);
    const files::ImageLayout colours =
        files::picture_layout(paths[kBaseColour], lattice.width, lattice.height,
                              source.settings.viewing.space, encoding, export_px_per_mm(source));
    const MapHeights heights = heights_of(source.film);
    if (told != nullptr) *told = heights;
    const shade::Renderer renderer(source.film, source.ground, lattice, source.settings, pool);
    MapWriter writer(paths, colours, heights, source.settings.lighting);
    shade::SurfaceSamples surface;
    const bool complete = for_each_band(lattice, keep_going, [&](const Rect& pixels) {
        renderer.render(pixels, nullptr, &surface);
        writer.write(surface);
    });
    if (complete) writer.finish();
    return complete ? files::ExportStatus::Written : files::ExportStatus::Stopped;
}

}  // namespace pastoso::recordings
