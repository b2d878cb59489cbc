#include "cli/scene_writer.hpp"

#include "cli/stopwatch.hpp"
#include "core/number_text.hpp"
#include "core/text_file.hpp"
#include "document/painting.hpp"
#include "files/image.hpp"
#include "recordings/scene_stops.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace pastoso::cli {
namespace {

using core::number_text;

bool is_among(double time_s, const std::vector<double>& times, double within) {
    return std::any_of(times.begin(), times.end(),
                       [&](double time) { return std::abs(time - time_s) <= within; });
}

files::GreyImage map_of(const grid::Shape& shape, const std::function<float(int, int)>& value) {
    files::GreyImage map{shape.width, shape.height, {}};
    for (int y = 0; y < shape.height; ++y)
        for (int x = 0; x < shape.width; ++x)
            map.values.push_back(value(x, y));
    return map;
}

std::string file_name(const char* what, double time_s, const char* extension) {
    return what + ("-" + number_text(time_s)) + "s" + extension;
}

}  // namespace

SceneWriter::SceneWriter(const recordings::SceneRun& run, bool cell_units, std::filesystem::path folder,
                         recordings::PictureStyle style, core::ThreadPool& pool)
    : run_(run),
      cell_units_(cell_units),
      folder_(std::move(folder)),
      style_(std::move(style)),
      pool_(pool),
      stops_(recordings::stops_of(run)) {}

void SceneWriter::write_due(const film::Simulation& simulation) {
    const recordings::SceneOutput& output = run_.output;
    const double now_s = simulation.time_s(), same = recordings::time_tolerance_s(run_);
    note_series(simulation);
    if (is_among(now_s, output.profiles_at_s, same)) note_profiles(simulation);
    if (is_among(now_s, output.pictures_at_s, same)) write_picture(simulation);
    if (is_among(now_s, output.heights_at_s, same)) write_height(simulation);
    if (output.magnification && std::abs(output.magnification->at_s - now_s) <= same)
        write_magnified(simulation);
}

void SceneWriter::write_tables() {
    times_.io_s += seconds_of([&] {
        const bool open =
            run_.scene.solver.edge_x == film::Edge::Open || run_.scene.solver.edge_y == film::Edge::Open;
        core::write_text_file(folder_ / "series.csv",
                              recordings::series_csv(series_, cell_units_, open));
        if (!run_.output.lines_along_x_mm.empty())
            core::write_text_file(folder_ / "profile_x.csv",
                                  recordings::profile_csv(film::Axis::X, lines_x_, cell_units_));
        if (!run_.output.lines_along_y_mm.empty())
            core::write_text_file(folder_ / "profile_y.csv",
                                  recordings::profile_csv(film::Axis::Y, lines_y_, cell_units_));
    });
}

pigment::LinearImage SceneWriter::render(const film::FilmState& film, const grid::Rect& cells,
                                         double scale) {
    pigment::LinearImage image;
    times_.shade_s += seconds_of([&] {
        const shade::RenderSettings settings{scale, run_.output.lighting, style_.viewing};
        image = shade::render(film, document::kPrimedGround, cells, settings, pool_);
    });
    return image;
}

double SceneWriter::px_per_mm(double scale) const {
    return cell_units_ ? 0.0 : scale / run_.scene.cell_mm;
}

void SceneWriter::note_series(const film::Simulation& simulation) {
    series_.push_back({simulation.time_s(), simulation.measures(), simulation.runoff_mm3(),
                       simulation.report().clamped_faces, simulation.report().steps});
}

void SceneWriter::note_profiles(const film::Simulation& simulation) {
    for (const double y_mm : run_.output.lines_along_x_mm)
        lines_x_.push_back({simulation.time_s(), y_mm, simulation.profile(film::Axis::X, y_mm)});
    for (const double x_mm : run_.output.lines_along_y_mm)
        lines_y_.push_back({simulation.time_s(), x_mm, simulation.profile(film::Axis::Y, x_mm)});
}

void SceneWriter::write_picture(const film::Simulation& simulation) {
    const std::string name = file_name("picture", simulation.time_s(), ".png");
    const double scale = run_.output.picture_scale;
    const pigment::LinearImage picture = render(simulation.film(), run_.scene.shape.cells(), scale);
    times_.io_s += seconds_of(
        [&] { files::write_picture(folder_ / name, picture, style_.encoding, px_per_mm(scale)); });
    pictures_.push_back(pigment::encode_srgb8(picture));
    moments_.push_back({simulation.time_s(), name, simulation.measures(), simulation.front()});
}

void SceneWriter::write_height(const film::Simulation& simulation) {
    const film::FilmState& film = simulation.film();
    const files::GreyImage heights =
        map_of(film.shape, [&](int x, int y) { return film::thickness_mm(film.thickness.at(x, y)); });
    times_.io_s += seconds_of([&] {
        files::write_image(folder_ / file_name("height", simulation.time_s(), ".exr"), heights);
    });
}

void SceneWriter::write_magnified(const film::Simulation& simulation) {
    constexpr int kGap_px = 16;
    const recordings::Magnification& part = *run_.output.magnification;
    const auto seen = [&](double scale) {
        return pigment::encode_srgb8(render(simulation.film(), part.cells, scale));
    };
    const pigment::Image8 both =
        shade::arranged({{seen(part.scale), shade::enlarged(seen(1.0), part.scale)}}, kGap_px);
    times_.io_s += seconds_of([&] {
        files::write_image(folder_ / file_name("magnified", simulation.time_s(), ".png"), both,
                           px_per_mm(part.scale));
    });
}

}  // namespace pastoso::cli
