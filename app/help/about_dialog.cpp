#include "help/about_dialog.hpp"

#include "core/text_file.hpp"
#include "core/version.hpp"
#include "help/help_view.hpp"

#include <QApplication>
#include <QDialogButtonBox>
#include <QFontDatabase>
#include <QLabel>
#include <QPlainTextEdit>
#include <QTabWidget>
#include <QVBoxLayout>

namespace pastoso::help {
namespace {

/// Makes tr() find these words.
struct Words {
    Q_DECLARE_TR_FUNCTIONS(AboutDialog)
};

QLabel* line(const QString& words, const QString& name = {}) {
    auto* label = new QLabel(words);
    label->setObjectName(name);
    label->setAlignment(Qt::AlignHCenter);
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return label;
}

QWidget* program_page() {
    constexpr int kIcon = 96;
    auto* page = new QWidget;
    auto* column = new QVBoxLayout(page);
    auto* icon = line({});
    icon->setPixmap(QApplication::windowIcon().pixmap(kIcon));
    column->addStretch();
    column->addWidget(icon);
    column->addWidget(line(QStringLiteral("Pastoso %1").arg(QString::fromLatin1(core::version())),
                           QStringLiteral("heading")));
    column->addWidget(line(Words::tr("Painting with thick wet paint")));
    column->addSpacing(12);
    column->addWidget(line(QStringLiteral("\u00a9 2026 %1").arg(Words::tr("The Pastoso authors"))));
    column->addWidget(
        line(Words::tr("Free software: you may use, study, share and change it under the GNU "
                       "General Public License, version 3 or later. It comes without any "
                       "warranty.")));
    column->addStretch();
    return page;
}

QWidget* licence_page(const Manual& manual) {
    auto* text =
        new QPlainTextEdit(QString::fromStdString(core::read_text_file(manual.beside("LICENSE"))));
    text->setObjectName(QStringLiteral("licence"));
    text->setReadOnly(true);
    text->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    return text;
}

QWidget* libraries_page(const Manual& manual) {
    auto* view = new HelpView(manual);
    view->show_topic(QStringLiteral("libraries"));
    return view;
}

}  // namespace

AboutDialog::AboutDialog(const Manual& manual, const std::vector<dialogs::Fact>& machine,
                         const std::vector<dialogs::Fact>& folders, QWidget* parent)
    : QDialog(parent) {
    setWindowTitle(tr("About Pastoso"));
    setObjectName(QStringLiteral("about_dialog"));
    auto* pages = new QTabWidget;
    pages->setDocumentMode(true);
    pages->addTab(program_page(), tr("Program"));
    pages->addTab(dialogs::fact_list(machine), tr("This machine"));
    pages->addTab(dialogs::fact_list(folders), tr("Folders"));
    pages->addTab(libraries_page(manual), tr("Libraries"));
    QWidget* licence = licence_page(manual);
    licence->setAccessibleName(tr("Licence"));
    pages->addTab(licence, tr("Licence"));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(14, 14, 14, 12);
    column->addWidget(pages, 1);
    column->addWidget(buttons);
    resize(640, 480);
}

}  // namespace pastoso::help
