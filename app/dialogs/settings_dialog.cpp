#include "dialogs/settings_dialog.hpp"

#include "appearance/terms.hpp"
#include "core/thread_count.hpp"
#include "tools/settings.hpp"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QTabWidget>
#include <QVBoxLayout>

namespace pastoso::dialogs {
namespace {

constexpr int kWidth = 560;

QLabel* note(const QString& sentence) {
    auto* label = new QLabel(sentence);
    label->setObjectName(QStringLiteral("reading"));
    label->setWordWrap(true);
    return label;
}

QFormLayout* form_on(QWidget* page) {
    auto* form = new QFormLayout(page);
    form->setContentsMargins(16, 16, 16, 16);
    form->setHorizontalSpacing(16);
    form->setVerticalSpacing(10);
    return form;
}

}  // namespace

SettingsDialog::SettingsDialog(tools::Preferences preferences, int undo_memory_MiB,
                               const QString& system_profile, const std::vector<Fact>& machine,
                               QWidget* parent)
    : QDialog(parent), preferences_(std::move(preferences)) {
    setWindowTitle(tr("Settings"));
    setObjectName(QStringLiteral("settings_dialog"));
    pages_ = new QTabWidget;
    pages_->setObjectName(QStringLiteral("pages"));
    pages_->setDocumentMode(true);
    pages_->addTab(make_appearance(), tr("Appearance"));
    pages_->addTab(make_colour(system_profile), tr("Colour"));
    pages_->addTab(make_keeping(undo_memory_MiB), tr("Undo and saving"));
    pages_->addTab(make_performance(), tr("Performance"));
    pages_->addTab(fact_list(machine), tr("This machine"));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(14, 14, 14, 12);
    column->setSpacing(12);
    column->addWidget(pages_, 1);
    column->addWidget(buttons);
    setMinimumWidth(kWidth);
}

void SettingsDialog::show_page(Page page) {
    pages_->setCurrentIndex(static_cast<int>(page));
}

QComboBox* SettingsDialog::add_choice(QFormLayout* form, const QString& words, const QString& name,
                                      const std::vector<std::pair<QString, std::string>>& choices,
                                      std::string tools::Preferences::*preference) {
    auto* box = new QComboBox;
    box->setObjectName(name);
    for (const auto& [shown, value] : choices)
        box->addItem(shown, QString::fromStdString(value));
    box->setCurrentIndex(box->findData(QString::fromStdString(preferences_.*preference)));
    connect(box, &QComboBox::activated, this, [this, box, preference] {
        preferences_.*preference = box->currentData().toString().toStdString();
        Q_EMIT changed(preferences_);
    });
    form->addRow(words, box);
    return box;
}

/// The path of an ICC profile, typed or chosen; empty: none.
QWidget* SettingsDialog::add_profile(QFormLayout* form, const QString& words, const QString& name,
                                     std::string tools::Preferences::*preference) {
    auto* row = new QWidget;
    auto* path = new QLineEdit(QString::fromStdString(preferences_.*preference));
    path->setObjectName(name);
    path->setAccessibleName(words);
    path->setClearButtonEnabled(true);
    path->setPlaceholderText(tr("None"));
    auto* choose = new QPushButton(tr("Choose..."));
    auto* parts = new QHBoxLayout(row);
    parts->setContentsMargins(0, 0, 0, 0);
    parts->addWidget(path, 1);
    parts->addWidget(choose);
    connect(path, &QLineEdit::textChanged, this,
            [this, preference](const QString& text) { preferences_.*preference = text.toStdString(); });
    connect(path, &QLineEdit::editingFinished, this, [this] { Q_EMIT changed(preferences_); });
    connect(choose, &QPushButton::clicked, this, [this, path, words] {
        const QString chosen = QFileDialog::getOpenFileName(
            this, words, path->text(), tr("ICC profiles (*.icc *.icm);;All files (*)"));
        if (chosen.isEmpty()) return;
        path->setText(chosen);
        Q_EMIT changed(preferences_);
    });
    form->addRow(words, row);
    return row;
}

void SettingsDialog::add_number(QFormLayout* form, const QString& words, const QString& name, int most,
                                const QString& words_for_none, const UnitWords& unit,
                                int tools::Preferences::*preference) {
    auto* box = new QSpinBox;
    box->setObjectName(name);
    box->setRange(0, most);
    box->setSpecialValueText(words_for_none);
    box->setKeyboardTracking(false);
    box->setValue(preferences_.*preference);
    box->setSuffix(unit(box->value()));
    connect(box, &QSpinBox::valueChanged, this, [this, box, unit, preference](int value) {
        box->setSuffix(unit(value));
        preferences_.*preference = value;
        Q_EMIT changed(preferences_);
    });
    form->addRow(words, box);
}

QWidget* SettingsDialog::make_appearance() {
    auto* page = new QWidget;
    QFormLayout* form = form_on(page);
    add_choice(form, tr("Theme"), QStringLiteral("theme"),
               {{tr("Dark"), "dark"}, {tr("Light"), "light"}}, &tools::Preferences::theme);
    form->addRow(QString(), note(tr("Both are neutral greys, so that nothing beside the canvas colours "
                                    "what you see on it.")));
    add_choice(form, tr("Language"), QStringLiteral("language"),
               {{tr("As on the desktop"), ""},
                {QStringLiteral("English"), "en"},
                {QStringLiteral("日本語"), "ja"},
                {QStringLiteral("Svenska"), "sv"},
                {QStringLiteral("繁體中文"), "zh_TW"}},
               &tools::Preferences::language);
    form->addRow(QString(), note(tr("Another language speaks from the next start on.")));
    return page;
}

QWidget* SettingsDialog::make_colour(const QString& system_profile) {
    auto* page = new QWidget;
    QFormLayout* form = form_on(page);
    const QString system = system_profile.isEmpty() ? tr("Of the system, which has none here")
                                                    : tr("Of the system (%1)").arg(system_profile);
    QComboBox* monitor = add_choice(form, tr("The screen's profile"), QStringLiteral("monitor"),
                                    {{system, ""}, {tr("None (sRGB)"), "none"}, {tr("A file"), "file"}},
                                    &tools::Preferences::monitor);
    QWidget* file = add_profile(form, tr("Its file"), QStringLiteral("monitor_file"),
                                &tools::Preferences::monitor_file);
    const auto follow = [monitor, file] { file->setEnabled(monitor->currentData() == "file"); };
    connect(monitor, &QComboBox::currentIndexChanged, file, follow);
    follow();
    form->addRow(QString(), note(tr("With the profile of your screen, canvas and swatches have the same "
                                    "colours as on any other that is measured. Files and exports are "
                                    "not changed.")));
    add_profile(form, tr("The printer's profile"), QStringLiteral("printer_file"),
                &tools::Preferences::printer_file);
    QLabel* proof =
        note(tr("For \"Soft proof\" and \"Gamut warning\" in the \"View\" menu: "
                "of your printer and paper, or of your printing house."));
    appearance::explain(proof, appearance::Term::SoftProof);
    form->addRow(QString(), proof);
    return page;
}

QWidget* SettingsDialog::make_keeping(int undo_memory_MiB) {
    constexpr int kStep_MiB = 256;
    auto* page = new QWidget;
    QFormLayout* form = form_on(page);
    auto* memory = new QSpinBox;
    memory->setObjectName(QStringLiteral("undo_memory"));
    memory->setRange(tools::kLeastUndoMemory_MiB, tools::kMostUndoMemory_MiB);
    memory->setSingleStep(kStep_MiB);
    memory->setSuffix(tr(" MB"));
    memory->setKeyboardTracking(false);
    memory->setValue(undo_memory_MiB);
    connect(memory, &QSpinBox::valueChanged, this, &SettingsDialog::undo_memory_changed);
    form->addRow(tr("Memory for undo"), memory);
    form->addRow(QString(), note(tr("The steps that you can return to. The oldest are given up when it "
                                    "is full; 500 are kept at most.")));
    add_number(
        form, tr("Save by itself every"), QStringLiteral("autosave"), tools::kMostAutosave_min,
        tr("Never"), [](int minutes) { return tr(" minute(s)", nullptr, minutes); },
        &tools::Preferences::autosave_min);
    form->addRow(QString(),
                 note(tr("Into the painting's own file, once it has one. Whatever you choose, "
                         "every stroke is kept aside within a second and offered to you "
                         "again should the program or the machine fail.")));
    return page;
}

QWidget* SettingsDialog::make_performance() {
    auto* page = new QWidget;
    QFormLayout* form = form_on(page);
    add_number(
        form, tr("Processors in use"), QStringLiteral("threads"), tools::kMostThreads,
        tr("All of the machine (%1)").arg(core::processor_count()), [](int) { return QString(); },
        &tools::Preferences::threads);
    form->addRow(QString(), note(tr("How many things the program works on at once, from the next "
                                    "painting on. The paint flows the same with any number.")));
    add_choice(form, tr("The canvas is drawn by"), QStringLiteral("drawn_by"),
               {{tr("What is faster here"), ""},
                {tr("The graphics card (OpenGL)"), "opengl"},
                {tr("The processor"), "processor"}},
               &tools::Preferences::drawn_by);
    form->addRow(QString(), note(tr("Choose the processor where a graphics driver shows the canvas "
                                    "wrongly.")));
    form->addRow(QString(), note(tr("How carefully moving paint is shown follows from how fast this "
                                    "machine draws; what stands still is always shown in full.")));
    return page;
}

}  // namespace pastoso::dialogs
