// What is made of the painting for other programs, while the painter goes on painting.
#pragma once

#include "commands/exporter.hpp"
#include "main/program/remembered_file.hpp"
#include "main/studio.hpp"
#include "tools/export_settings.hpp"

#include <filesystem>
#include <optional>

#include <QObject>

namespace pastoso::panels {
class WorkProgress;
}

namespace pastoso::main {

class LightChoice;
class ProjectFiles;

class Exporting : public QObject {
    Q_OBJECT
  public:
    /// `files` say where the painting is, `light` in which light it is seen.
    Exporting(Studio& studio, const ProjectFiles& files, const LightChoice& light);

    /// Makes a picture, layers, maps, a relief or a time-lapse of the painting as it is now, in the
    /// background. Not while one is being made.
    void start(const tools::ExportSettings& settings, const std::filesystem::path& path);

    /// The same for a copy in layers; a name that none can have is told.
    void start_copy(const std::filesystem::path& path);

    commands::Exporter& exporter() { return exporter_; }

    /// Whether the window may close as far as an export is concerned.
    bool may_stop();

  private:
    void ask(const tools::ExportSettings& settings);
    void repeat();
    void end(const commands::ExportOutcome& outcome);
    bool may_begin();
    void begin(commands::ExportJob job);
    void ask_save_copy();
    void ask_save_recording();
    void show_commands();
    std::filesystem::path proposal() const;
    tools::ExportLight light() const;
    void recall();
    void remember();

    Studio& studio_;
    const ProjectFiles& files_;
    const LightChoice& light_;
    commands::Exporter exporter_;
    panels::WorkProgress* progress_ = nullptr;
    tools::ExportSettings settings_;
    RememberedFile file_;
    bool closes_after_ = false;
    struct Exported {
        tools::ExportSettings settings;
        std::filesystem::path path;
    };
    std::optional<Exported> exported_;  ///< the last export of this painting
};

}  // namespace pastoso::main
