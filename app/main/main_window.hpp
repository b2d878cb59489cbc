// The window: puts session, easel, canvas and panels together and connects them.
#pragma once

#include "brush/preset_library.hpp"
#include "commands/command_registry.hpp"
#include "commands/exporter.hpp"
#include "commands/project_saver.hpp"
#include "document/events.hpp"
#include "session/layer_painter.hpp"
#include "session/paint_session.hpp"
#include "session/thumbnail_painter.hpp"
#include "tools/easel.hpp"
#include "tools/export_settings.hpp"
#include "tools/guide_handles.hpp"
#include "tools/settings.hpp"
#include "view/canvas_view.hpp"

#include <filesystem>
#include <map>
#include <memory>
#include <optional>

#include <QByteArray>
#include <QFileSystemWatcher>
#include <QMainWindow>
#include <QPointer>
#include <QTimer>

class QComboBox;
class QDockWidget;
class QMenu;

namespace pastoso::dialogs {
class SelectRangeDialog;
class TransformDialog;
}  // namespace pastoso::dialogs

namespace pastoso::panels {
class BrushPanel;
class ColourPanel;
class CurvesPanel;
class EaselPanel;
class GuidesPanel;
class LayerPanel;
class LoadPanel;
class PaintPanel;
class StatusReadings;
class TracingPanel;
class WorkProgress;
}  // namespace pastoso::panels

namespace pastoso::main {

class ViewCommands;

class MainWindow : public QMainWindow {
    Q_OBJECT
  public:
    /// Throws core::InputError when there can be no such canvas. What is painted is kept on the disk as
    /// it happens, to be recovered, unless `keeps_journal` says otherwise.
    explicit MainWindow(const document::CanvasSettings& canvas, bool keeps_journal = true);
    ~MainWindow() override;

    /// Puts up another canvas with the same tools. Throws core::InputError and keeps the old one when it
    /// cannot.
    void new_canvas(const document::CanvasSettings& canvas);

    /// Puts up the painting in a project file, as it was; a file of any other name as open_picture()
    /// does. Throws core::InputError and keeps the old one when it cannot.
    void open_painting(const QString& path);

    /// Puts up a new canvas with a picture or the layers of an OpenRaster file as dry paint, which has
    /// no file yet. Throws core::InputError and keeps the old painting when it cannot.
    void open_picture(const QString& path);

    /// Puts a picture onto the canvas as a layer of dry paint, in the middle and as large as it fits.
    /// Throws core::InputError when it is none.
    void paint_picture(const QString& path);

    /// Lays a picture below the paint to be traced, in the middle and as large as it fits. Throws
    /// core::InputError when it is none.
    void trace_picture(const QString& path);

    /// Writes the painting to a project file, in the background. From now on that is its file.
    void save_painting(const QString& path);

    /// Puts up a painting that a program left unfinished; its journal then goes. Throws core::InputError
    /// and keeps both the old painting and the journal when it cannot.
    void recover_painting(const std::filesystem::path& journal);

    /// Asks what to do with unfinished paintings, if there are any.
    void offer_recovery();

    /// Puts up the recording's canvas and paints on it what was recorded.
    void replay(const document::Recording& recording);

    session::PaintSession& session() { return *session_; }
    tools::Easel& easel() { return *easel_; }
    view::CanvasView& canvas() { return *canvas_; }
    view::CanvasView& well() { return *well_; }
    commands::CommandRegistry& commands() { return commands_; }
    commands::Exporter& exporter() { return exporter_; }
    commands::ProjectSaver& project_saver() { return project_saver_; }

    /// Makes a picture, layers, maps, a relief or a time-lapse of the painting as it is now, in the
    /// background. Not while one is being made.
    void export_painting(const tools::ExportSettings& settings, const std::filesystem::path& path);

    /// Shows the painting in a bundled light, by name, or in that of a CSV file
    /// (pigment/illuminant.hpp). What is none is told, and the light stays.
    void use_light(const QString& name_or_path);

    /// Shows it in the colours of that space.
    void use_space(pigment::WorkingSpace space);

    /// Shows the colours of a .gpl file to choose from. What is none is told.
    void open_palette(const QString& path);

  protected:
    void changeEvent(QEvent* event) override;
    void closeEvent(QCloseEvent* event) override;

  private:
    void start_session(const document::CanvasSettings& canvas);
    void start_session(std::unique_ptr<core::ThreadPool> pool,
                       std::unique_ptr<document::Painting> painting, document::Recording past,
                       journal::Beginning beginning);
    std::unique_ptr<journal::JournalWriter> new_journal(const journal::Beginning& beginning);
    void take_up_hand(const document::Recording& past);
    void lay_out();
    void make_tool_bar();
    void make_panels();
    panels::BrushPanel* make_brush_panel();
    void make_docks();
    QDockWidget* add_dock(commands::Command command, const QString& name, const QString& title,
                          QWidget* content);
    void connect_panels();
    void connect_docks();
    void connect_light_commands();
    void connect_canvas();
    void connect_commands();
    void connect_file_commands();
    void connect_project_commands();
    void connect_picture_commands();
    void ask_paint_picture();
    static QString picture_endings();  ///< of the files that are offered
    void fill_recent();
    void try_to_open(const QString& path);
    void ask_open_painting();
    bool ask_save_painting();  ///< false: the painter thought better of it
    void show_title();
    void make_well_panel();
    void open_well(bool open);
    void connect_well();
    void connect_brush_commands();
    void connect_guide_commands();
    void connect_selection();
    void draw_areas(std::optional<view::AreaForm> form);
    void tell_combination(grid::Combination how);
    void warn_outside(const QPointF& canvas_mm);
    void ask_range(bool wetness);
    void preview_range(bool wetness);
    void connect_canvas_size();
    void ask_canvas_size();
    bool canvas_is_lent();
    void crop_to_selection();
    void resize_canvas(const document::ResizeCanvas& resize);
    std::optional<glm::dvec2> follow_cloth(std::shared_ptr<const document::BareCanvas> bare);
    void connect_transform();
    void begin_transform();
    void show_transform(const tools::TransformFrame& frame, const document::Snapshot& painting);
    void open_transform_dialog(const tools::TransformFrame& frame, const QSizeF& canvas_mm);
    bool end_transform();      ///< false: there was none
    bool give_up_transform();  ///< the same, and says so
    void apply_transform();
    void follow_transform(const document::Snapshot& painting, const session::Status& status);
    void show_selection(const document::Snapshot& painting);
    void show_selection_reading();
    void connect_tracing();
    void ask_trace_picture();
    void show_tracing(const document::Snapshot& painting);
    panels::LayerPanel* make_layer_panel();
    void connect_layers();
    void add_layer();
    void remove_layers();
    void clear_layers();
    void group_layers();
    void ungroup_layers();
    void choose_neighbour(bool above);
    void move_layer(bool up);
    void show_layers(const document::Snapshot& painting);
    void show_layer_commands();
    void want_layer_pictures();
    void forget_layer_pictures();
    void show_published();
    void show_well(const document::Snapshot& painting);
    void show_hand();
    void show_guides();
    void set_symmetry(const brush::Symmetry& symmetry);
    void set_mirrors(bool upright, bool level);
    void move_guide(const tools::Guide& guide);
    void lay_ruler(bool lies);
    void lay_ellipse(bool lies);
    void remove_guides();
    void choose_paint(const document::PaintRecipe& paint);
    void show_paint(const document::PaintRecipe& paint);
    void pick_at_next_click(std::optional<tools::Pick> pick);
    void pick_from(document::Surface surface, const QPointF& place_mm, tools::Pick pick);
    void pick_paint(const tools::PickedPaint& paint);
    void pick_colour(const document::Snapshot& there, const QPointF& place_mm);
    void recall();
    void remember();
    void remember_paints();
    void ask_undo_memory();
    void set_undo_memory(int MiB);
    void reset_panels();
    void read_brushes();
    void reread_brushes();
    void list_brushes();
    void take_brush(const QString& name, double width_mm);
    bool own_brush_in_hand() const;
    brush::Preset kept_brush() const;
    void save_brush();
    void rename_brush();
    void delete_brush();
    bool ask_name(const QString& title, QString& name);
    bool confirmed(const QString& question, const QString& action);
    void show_enabled(const session::Status& status);
    bool may_discard();
    void ask_new_canvas();
    void ask_light();
    void show_under(const pigment::Viewing& viewing);  ///< canvas and well
    void show_light();
    void connect_export();
    void show_export_commands();
    std::filesystem::path export_proposal() const;
    tools::ExportLight export_light() const;
    bool may_begin_export();
    void ask_export();
    void export_again();
    void end_export(const commands::ExportOutcome& outcome);
    bool may_stop_export();
    void remember_export();
    void ask_save_recording();
    void report(const QString& sentence);
    void report_refusal(QString sentence);

    const bool keeps_journal_;
    commands::CommandRegistry commands_;
    std::unique_ptr<tools::Easel> easel_;
    std::unique_ptr<session::PaintSession> session_;
    std::unique_ptr<session::ThumbnailPainter> thumbnails_;
    std::unique_ptr<session::LayerPainter> layer_painter_;
    /// What the pictures of the layers show.
    std::map<document::LayerId, std::shared_ptr<const film::FilmState>> pictured_;
    QTimer layers_changed_;  ///< soon after their paint
    commands::ProjectSaver project_saver_;
    commands::Exporter exporter_;
    tools::ExportSettings export_settings_;
    bool closes_after_export_ = false;
    struct Exported {
        tools::ExportSettings settings;
        std::filesystem::path path;
    };
    std::optional<Exported> exported_;  ///< the last export of this painting
    QString path_;                      ///< of the project file; empty: not saved yet
    std::int64_t saved_changes_ = 0;
    std::optional<std::uint64_t> journal_events_saved_;  ///< of the painting that is being saved
    QMenu* recent_ = nullptr;
    QString light_ = QStringLiteral("D65");
    brush::PresetLibrary library_;
    QFileSystemWatcher brush_files_;
    QTimer brushes_changed_;  ///< soon after their files
    QTimer paints_changed_;   ///< soon after the last of several changes
    int undo_memory_MiB_ = tools::kUndoMemory_MiB;
    bool settings_usable_ = true;  ///< their file is none that cannot be read, which is left alone
    bool shelf_usable_ = true;
    bool export_settings_usable_ = true;
    bool well_sized_ = false;  ///< it was opened before, or stands as it was remembered
    QByteArray first_panels_;  ///< how the panels stand unless the painter moves them
    std::map<commands::Command, QDockWidget*> docks_;
    view::CanvasView* canvas_ = nullptr;
    view::CanvasView* well_ = nullptr;
    std::shared_ptr<const document::BareCanvas> shown_bare_;  ///< of this painting; null at first
    std::shared_ptr<const document::Snapshot> shown_well_;
    std::optional<view::AreaForm> area_form_;  ///< what a press on the canvas draws; none: it paints
    document::Selection shown_selection_;
    QPointer<dialogs::SelectRangeDialog> range_;
    /// What the frame on the canvas stands around.
    struct Transforming {
        document::LayerId layer = 0;
        document::Selection selection;
        std::shared_ptr<const document::BareCanvas> bare;
    };
    std::optional<Transforming> transforming_;
    QPointer<dialogs::TransformDialog> transform_dialog_;
    QDockWidget* well_panel_ = nullptr;
    panels::BrushPanel* brushes_ = nullptr;
    panels::PaintPanel* paints_ = nullptr;
    panels::ColourPanel* colours_ = nullptr;
    panels::LoadPanel* load_ = nullptr;
    panels::CurvesPanel* curves_ = nullptr;
    panels::GuidesPanel* guides_ = nullptr;
    panels::LayerPanel* layers_ = nullptr;
    panels::TracingPanel* tracing_ = nullptr;
    panels::EaselPanel* stand_ = nullptr;
    panels::StatusReadings* readings_ = nullptr;
    panels::WorkProgress* export_progress_ = nullptr;
    QComboBox* medium_ = nullptr;
    ViewCommands* view_commands_ = nullptr;
};

}  // namespace pastoso::main
