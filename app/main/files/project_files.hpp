// Paintings and their files: a fresh canvas, opening, saving, recovering, and what would be lost.
//
// Paintings are made beside the window. The one on the easel stays there, and can be painted on, until
// the other is whole; where one cannot be had, that is told in a sentence and nothing else happens.
#pragma once

#include "commands/file_stamp.hpp"
#include "commands/project_saver.hpp"
#include "journal/journal_writer.hpp"
#include "main/files/loading.hpp"
#include "main/files/prepared_painting.hpp"
#include "main/studio.hpp"
#include "project/project.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
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
    ProjectFiles(Studio& studio, Loading& loading, bool keeps_journal);

    /// Puts up the first canvas.
    void start(MadePainting canvas);

    using Then = std::function<void()>;

    // All of these begin to make a painting, in place of any that is being made, and put it up once it
    // is there. What was painted until now may be lost by that; what is painted from now on is asked
    // about before.

    /// Another canvas with the same tools; `then` something more.
    void new_canvas(const document::CanvasSettings& canvas, const Then& then = {});

    /// The painting in a project file, as it was; a file of any other name as open_picture() does.
    void open_painting(const QString& path);

    /// A new canvas with a picture or the layers of an OpenRaster file as dry paint, which has no file
    /// yet.
    void open_picture(const QString& path);

    /// A painting that a program left unfinished; its journal then goes.
    void recover_painting(const std::filesystem::path& journal);

    /// The recording's canvas, on which is painted what was recorded; at once where such a canvas stands
    /// on the easel.
    void replay(const document::Recording& recording);
    /// The same of a recording in a file, on a canvas of its own.
    void replay_file(const std::filesystem::path& recording);

    /// A painting that has no file yet; `then` something more.
    void put_up_unsaved(std::shared_ptr<const project::Project> project, const Then& then = {});

    /// Whether open_painting() takes files of that name; others may be recordings.
    static bool opens(const QString& path);

    /// Writes the painting to a project file, in the background, whatever stands there. As soon as it
    /// is written, that is its file; where it cannot be, the painter is told and the painting keeps the
    /// file that it has.
    void save_painting(const QString& path, core::Replaced = core::Replaced::Writable);

    /// The same into the painting's own file, or one that the painter names. Asks first where another
    /// program has changed the file, or nobody may write to it. False: the painter thought better of it.
    bool save();

    /// Into a file of the next number beside its own, which is its file from then on; no file is
    /// replaced. A painting without a file is given one by the painter.
    void save_version();

    /// Into its file, where it has one and has changed. Where save() would ask, tells the painter.
    void save_by_itself();

    /// Asks what to do with unfinished paintings, if there are any.
    void offer_recovery();

    /// The same when the painter asks for it: first what is on the easel may be saved. Nothing happens
    /// where the painter thinks better of it.
    void ask_to_put_up(const document::CanvasSettings& canvas);
    void ask_to_put_up_unsaved(std::shared_ptr<const project::Project> project, const Then& then);
    void ask_to_open(const QString& path);
    void ask_to_recover(const std::filesystem::path& journal);
    /// A recording's canvas, on which is painted what was recorded, as fast as it goes. Nothing of it
    /// needs to be saved until the painter goes on with it.
    void ask_to_watch(const std::filesystem::path& recording);
    void ask_new_canvas();
    /// A bare canvas of the same kind takes its place; `then` something more.
    void ask_to_close(const Then& then);
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
    /// On the canvas that has just been put up: so thick while it is wet.
    void ground_wanted(double thickness_mm);

  private:
    /// Puts it on the easel where that is agreed to when it is there.
    void make(const QString& words, Loading::Make work);
    using PutUpWith = std::function<void(PreparedPainting&, const document::Recording&)>;
    void make_canvas_of(const std::filesystem::path& recording, const PutUpWith& put_up);
    bool may_replace();
    void put_up(PreparedPainting& painting);
    void put_up_new(PreparedPainting& painting);
    void put_up_new_to_save(PreparedPainting& painting);
    void put_up_watched(PreparedPainting& painting, const document::Recording& recording);
    struct RecoveredPainting;
    void put_up_recovered(RecoveredPainting& found);
    JournalTerms journal_terms();
    void take_up_hand(const document::Recording& past);
    void tell_arithmetic(const document::Recording& recording);
    bool ask_save_painting();  ///< false: the painter thought better of it
    bool save_to(const QString& path);
    QString objection_to(const QString& path) const;
    void end_saving(const commands::SaveOutcome& outcome);
    void show_trouble(const journal::Trouble& trouble);
    void fill_recent();
    void show_unsaved();
    void show_modified();

    Studio& studio_;
    Loading& loading_;
    const bool keeps_journal_;
    QString path_, place_;
    std::optional<commands::FileStamp> stamp_;  ///< of that file as the painting was read or written
    std::int64_t saved_changes_ = 0;
    std::int64_t given_up_changes_ = 0;  ///< of the painting on the easel, for the one being made
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
    std::uint64_t journal_ = 0;     ///< the number of the one in use
    QMenu* recent_ = nullptr;
    commands::ProjectSaver saver_;
};

}  // namespace pastoso::main
