// What ExportDialog does when something is chosen in it.

#include "appearance/shown_message.hpp"
#include "core/fault.hpp"
#include "dialogs/export_dialog.hpp"
#include "document/canvas.hpp"
#include "tools/export_names.hpp"

#include <cmath>

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>

namespace pastoso::dialogs {
namespace {

using tools::ExportForm;
using Path = std::filesystem::path;

bool is_folder(const tools::ExportFormat& format) {
    return *format.ending == '\0';
}

QString words_of(const tools::ExportFormat& format) {
    return QCoreApplication::translate("pastoso::tools", format.words);
}

bool has_quality(const tools::ExportFormat& format) {
    const std::string ending = format.ending;
    return ending == ".jpg" || ending == ".webp";
}

/// A sentence that breaks its lines within long paths too.
QString breakable(QString sentence) {
    return sentence.replace(QLatin1Char('/'), QStringLiteral("/\u200b"));
}

/// Without the folder, which stands above it.
QString fault_words(const core::Message& fault, const Path& path) {
    QString sentence = appearance::shown_message(fault);
    const QString folder = QString::fromStdString(path.parent_path().string()) + QLatin1Char('/');
    if (sentence.startsWith(folder)) sentence.remove(0, folder.size());
    return breakable(sentence);
}

}  // namespace

Path ExportDialog::path() const {
    QString text = path_->text().trimmed();
    if (text.startsWith(QStringLiteral("~/"))) text.replace(0, 1, QDir::homePath());
    if (text.isEmpty() || text.endsWith(QLatin1Char('/'))) return {};
    return tools::with_ending(proposal_.parent_path() / text.toStdString(), settings_.format());
}

void ExportDialog::choose_form(ExportForm form) {
    settings_.form = form;
    form_->setCurrentIndex(static_cast<int>(form));
    list_formats();
    propose_name();
    show_rows();
    show_size();
    show_outcome();
}

void ExportDialog::choose_format(std::size_t format) {
    settings_.formats[static_cast<std::size_t>(settings_.form)] = format;
    propose_name();
    show_rows();
    show_outcome();
}

void ExportDialog::follow_name(const QString& text) {
    named_ = true;
    std::size_t& format = settings_.formats[static_cast<std::size_t>(settings_.form)];
    format = tools::format_of(text.trimmed().toStdString(), settings_.form, format).value_or(format);
    format_->setCurrentIndex(static_cast<int>(format));
    show_rows();
    show_outcome();
}

/// A name that was not typed gives way to files that are there; a folder for frames always does.
void ExportDialog::propose_name() {
    const tools::ExportFormat& format = settings_.format();
    Path name = named_ && !path_->text().isEmpty() ? path() : tools::with_ending(proposal_, format);
    if (is_folder(format) && !named_) name += "-frames";
    if (is_folder(format) || !named_) name = tools::untaken(name, settings_.form);
    path_->setText(QString::fromStdString(name.string()));
    const auto folder = static_cast<int>(name.parent_path().string().size()) + 1;
    path_->setSelection(folder, static_cast<int>(name.stem().string().size()));
}

void ExportDialog::browse() {
    QString chosen;
    const Path name = path();
    const QString present = QString::fromStdString(name.string());
    if (is_folder(settings_.format())) {
        chosen = QFileDialog::getExistingDirectory(this, tr("Where the folder is put"),
                                                   QFileInfo(present).path());
        if (!chosen.isEmpty()) chosen += QLatin1Char('/') + QFileInfo(present).fileName();
    } else {
        const QString filter =
            QStringLiteral("%1 (*%2)")
                .arg(words_of(settings_.format()), QString::fromLatin1(settings_.format().ending));
        chosen =
            QFileDialog::getSaveFileName(this, tr("Export"), present, filter + tr(";;All files (*)"),
                                         nullptr, QFileDialog::DontConfirmOverwrite);
    }
    if (chosen.isEmpty()) return;
    path_->setText(chosen);
    follow_name(chosen);
}

void ExportDialog::list_formats() {
    format_->clear();
    for (const tools::ExportFormat& format : tools::export_formats(settings_.form))
        format_->addItem(words_of(format));
    format_->setCurrentIndex(
        static_cast<int>(settings_.formats[static_cast<std::size_t>(settings_.form)]));
}

void ExportDialog::list_colours() {
    const QString present = QString::fromStdString(settings_.profile);
    colours_->clear();
    colours_->addItem(tr("sRGB"), QStringLiteral("srgb"));
    colours_->addItem(tr("Display P3"), QStringLiteral("display-p3"));
    if (colours_->findData(present) < 0) colours_->addItem(QFileInfo(present).fileName(), present);
    colours_->addItem(tr("ICC profile..."), QString());
    colours_->setCurrentIndex(colours_->findData(present));
}

void ExportDialog::choose_colours() {
    QString chosen = colours_->currentData().toString();
    if (chosen.isEmpty())
        chosen = QFileDialog::getOpenFileName(this, tr("ICC profile"), {},
                                              tr("ICC profiles (*.icc *.icm);;All files (*)"));
    if (!chosen.isEmpty()) settings_.profile = chosen.toStdString();
    list_colours();
    show_outcome();
}

int ExportDialog::cells_across() const {
    if (settings_.form == ExportForm::Timelapse)
        return document::canvas_shape(film_canvas(subject_, settings_)).width;
    return recordings::exported_cells(subject_.canvas,
                                      tools::export_choice(settings_, path(), subject_.light))
        .shape.width;
}

void ExportDialog::show_size() {
    const QSignalBlocker quiet(width_);
    width_->setRange(1, static_cast<int>(tools::kMostExportScale) * cells_across());
    width_->setValue(static_cast<int>(std::lround(settings_.scale * cells_across())));
}

void ExportDialog::show_rows() {
    static const QString explanations[tools::kExportForms] = {
        tr("What the painting looks like."),
        tr("The picture, and of every layer its colours, normals, heights in mm, wetness, gloss and "
           "cover, "
           "as channels of one file."),
        tr("Base colour, normal (OpenGL, +Y up), height and roughness, a file for each."),
        tr("The paint as it stands on the canvas: a closed solid in millimetres."),
        tr("How the painting came about. It is painted once more, which takes a while.")};
    explanation_->setText(explanations[static_cast<std::size_t>(settings_.form)]);
    const ExportForm form = settings_.form;
    const tools::ExportFormat& format = settings_.format();
    const bool film = form == ExportForm::Timelapse, relief = form == ExportForm::Relief;
    const bool video = film && !is_folder(format);
    labels_.at(path_row_)->setText(is_folder(format) ? tr("&Folder") : tr("&File name"));
    show_row(format_, format_->count() > 1);
    show_row(quality_, form == ExportForm::Picture && has_quality(format));
    show_row(surface_, form == ExportForm::Picture);
    show_row(size_row_, !relief);
    show_row(colours_, !relief && !video);
    show_row(lit_, !relief && form != ExportForm::Maps);
    for (QDoubleSpinBox* box : {base_, exaggeration_, resolution_})
        show_row(box, relief);
    for (QDoubleSpinBox* box : {speed_, fps_, film_cells_})
        show_row(box, film);
}

/// Files are replaced on demand alone: the button says so.
void ExportDialog::show_outcome() {
    const Path file = path();
    const bool replaces = !file.empty() && tools::is_taken(file, settings_.form);
    export_->setText(replaces && !is_folder(settings_.format()) ? tr("Replace") : tr("Export"));
    const core::Message fault =
        core::fault_of([&] { outcome_->setText(export_summary(subject_, settings_, file)); });
    if (!fault.empty()) outcome_->setText(fault_words(fault, file));
    export_->setEnabled(fault.empty());
    layout()->activate();
    resize(width(), layout()->totalHeightForWidth(width()));
}

}  // namespace pastoso::dialogs
