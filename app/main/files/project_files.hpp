// Paintings and their files: a fresh canvas, opening, saving, recovering, and what would be lost.
#pragma once

#include "commands/file_stamp.hpp"
#include "commands/project_saver.hpp"
#include "journal/journal_writer.hpp"
#include "main/studio.hpp"
#include "project/project.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>

#include <QObject>
#include <QString>

class QMenu;

namespace pastoso::main {

class ProjectFiles : public QObject {
    Q_OBJECT
  public:
    /// What is painted is kept on the disk as it happens, to be recovered, where `keeps_journal`.
    ProjectFiles(Studio& studio, bool keeps_journal);

    /// Puts up the first canvas. Throws core::InputError when there can be no such canvas.
    void start(const document::CanvasSettings& canvas);

    /// Puts up another canvas with the same tools. Throws core::InputError and keeps the old one when it
    /// cannot.
    void new_canvas(const document::CanvasSettings& canvas);

    /// Puts up the painting in a project file, as it was; a file of any other name as open_picture()
    /// does. Throws core::InputError and keeps the old one when it cannot.
    void open_painting(const QString& path);

    /// Puts up a new canvas with a picture or the layers of an OpenRaster file as dry paint, which has
    /// no file yet. Throws core::InputError and keeps the old painting when it cannot.
    void open_picture(const QString& path);

    /// Whether open_painting() takes files of that name; others may be recordings.
    static bool opens(const QString& path);

    /// Writes the painting to a project file, in the background, whatever stands there. As soon as it
    /// is written, that is its file; where it cannot be, the painter is told and the painting keeps the
    /// file that it has.
    void save_painting(const QString& path, core::WriteProtected = core::WriteProtected::Refused);

    /// The same into the painting's own file, or one that the painter names. Asks first where another
    /// program has changed the file, or nobody may write to it. False: the painter thought better of it.
    bool save();

    /// Into its file, where it has one and has changed. Where save() would ask, tells the painter.
    void save_by_itself();

    /// Puts up a painting that a program left unfinished; its journal then goes. Throws core::InputError
    /// and keeps both the old painting and the journal when it cannot.
    void recover_painting(const std::filesystem::path& journal);

    /// Asks what to do with unfinished paintings, if there are any.
    void offer_recovery();

    /// Puts up the recording's canvas and paints on it what was recorded.
    void replay(const document::Recording& recording);

    /// Paints a recording on a canvas of its own, as fast as it goes. Nothing of it needs to be saved
    /// until the painter goes on with it. Throws core::InputError as new_canvas() does.
    void watch(const document::Recording& recording);

    /// Puts up a painting that has no file yet.
    void put_up_unsaved(std::shared_ptr<const project::Project> project);

    /// The same when the painter asks for it: first what is on the easel may be saved, and what goes
    /// wrong is told. Nothing happens where the painter thinks better of it.
    void ask_to_put_up(const document::CanvasSettings& canvas);
    /// Whether it stands there.
    bool ask_to_put_up_unsaved(std::shared_ptr<const project::Project> project);
    void ask_to_open(const QString& path);
    void ask_to_recover(const std::filesystem::path& journal);
    void ask_to_watch(const std::filesystem::path& recording);
    void ask_new_canvas();
    void ask_open_painting();

    /// Whether the painting on the easel has been worked on, or stands in a file.
    bool begun() const;

    /// Of the project file; empty: not saved yet.
    const QString& path() const { return path_; }
    commands::ProjectSaver& saver() { return saver_; }

    /// Whether nothing would be lost with this painting, or the painter agrees to lose it.
    bool may_discard();

    /// The star of a painting that is not saved follows the name.
    void show_title();
    /// In the title: what stands in the canvas' place; empty: the canvas.
    void show_place(const QString& name);

  Q_SIGNALS:
    /// The painting is going to be kept as it is: what waits for the hand to rest is to be done now.
    void about_to_keep();

  private:
    void start(std::unique_ptr<core::ThreadPool> pool, std::unique_ptr<document::Painting> painting,
               document::Recording past, journal::Beginning beginning);
    session::PaintSession::BeginJournal journal_for(const journal::Beginning& beginning);
    std::unique_ptr<journal::JournalWriter> begun_journal(
        const session::PaintSession::BeginJournal& begin);
    void take_up_hand(const document::Recording& past);
    void tell_arithmetic(const document::Recording& recording);
    void try_to_open(const QString& path);
    bool ask_save_painting();  ///< false: the painter thought better of it
    bool save_to(const QString& path);
    QString objection_to(const QString& path) const;
    void end_saving(const commands::SaveOutcome& outcome);
    void show_trouble(const journal::Trouble& trouble);
    void fill_recent();
    void show_unsaved();
    void show_modified();

    Studio& studio_;
    const bool keeps_journal_;
    QString path_, place_;
    std::optional<commands::FileStamp> stamp_;  ///< of that file as the painting was read or written
    std::int64_t saved_changes_ = 0;
    bool watched_ = false;  ///< a recording is being painted that needs no saving
    struct Saving {
        std::uint64_t number = 0;  ///< the saver's
        QString path;
        std::int64_t changes = 0;
        std::uint64_t journal_events = 0;
    };
    std::optional<Saving> saving_;  ///< of the painting on the easel, under way
    bool save_waits_ = false;       ///< for the stroke in progress to end
    std::uint64_t journals_ = 0;    ///< begun so far
    QMenu* recent_ = nullptr;
    commands::ProjectSaver saver_;
};

}  // namespace pastoso::main
