// What a run of a scene writes into its folder while it goes on.
#pragma once

#include "cli/picture.hpp"
#include "film/laboratory/simulation.hpp"
#include "recordings/scene_json.hpp"
#include "recordings/series_csv.hpp"
#include "shade/picture_sheet.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace pastoso::cli {

/// The state at one of the times that pictures are asked for.
struct SceneMoment {
    double t_s = 0.0;
    std::string picture;  ///< file name in the run's folder
    film::Measures measures;
    std::optional<film::Front> front;
};

struct SceneTimes {
    double shade_s = 0.0, io_s = 0.0;
};

class SceneWriter {
  public:
    SceneWriter(const recordings::SceneRun& run, bool cell_units, std::filesystem::path folder,
                recordings::PictureStyle style, core::ThreadPool& pool);

    /// The times at which write_due() wants to be called, ascending, from 0 to the run's duration.
    const std::vector<double>& stops() const { return stops_; }

    /// Writes the pictures and heights due now, and notes a line of the series.
    void write_due(const film::Simulation& simulation);

    /// Writes the tables: series.csv, and profile_x.csv and profile_y.csv where lines are asked for.
    void write_tables();

    const std::vector<SceneMoment>& moments() const { return moments_; }
    const std::vector<recordings::SeriesRow>& series() const { return series_; }
    const std::vector<pigment::Image8>& pictures() const { return pictures_; }
    const SceneTimes& times() const { return times_; }

  private:
    pigment::LinearImage render(const film::FilmState& film, const grid::Rect& cells, double scale);
    double px_per_mm(double scale) const;  ///< 0 where a run is in cells
    void note_series(const film::Simulation& simulation);
    void note_profiles(const film::Simulation& simulation);
    void write_picture(const film::Simulation& simulation);
    void write_height(const film::Simulation& simulation);
    void write_magnified(const film::Simulation& simulation);

    const recordings::SceneRun& run_;
    bool cell_units_;
    std::filesystem::path folder_;
    recordings::PictureStyle style_;
    core::ThreadPool& pool_;
    std::vector<double> stops_;
    std::vector<recordings::SeriesRow> series_;
    std::vector<recordings::ProfileLine> lines_x_, lines_y_;
    std::vector<SceneMoment> moments_;
    std::vector<pigment::Image8> pictures_;
    SceneTimes times_;
};

}  // namespace pastoso::cli
