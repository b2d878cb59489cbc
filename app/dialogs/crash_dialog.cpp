#include "dialogs/crash_dialog.hpp"

#include <QApplication>
#include <QClipboard>
#include <QDialogButtonBox>
#include <QFontDatabase>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QVBoxLayout>

namespace pastoso::dialogs {

CrashDialog::CrashDialog(const QString& report, const QString& file, QWidget* parent)
    : GrowingDialog(parent) {
    setWindowTitle(tr("Pastoso failed the last time"));
    setObjectName(QStringLiteral("crash_dialog"));
    auto* words =
        new QLabel(tr("We are sorry. What you had painted was kept and is offered to you next. "
                      "This report says where the program was; it tells nothing of your "
                      "painting. With it the mistake can be found."));
    words->setWordWrap(true);
    auto* text = new QPlainTextEdit(report);
    text->setObjectName(QStringLiteral("report"));
    text->setAccessibleName(tr("Report"));
    text->setReadOnly(true);
    text->setLineWrapMode(QPlainTextEdit::NoWrap);
    text->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    auto* place = new QLabel(tr("It is kept as %1.").arg(file));
    place->setObjectName(QStringLiteral("reading"));
    place->setWordWrap(true);
    place->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    QPushButton* copy = buttons->addButton(tr("Copy the report"), QDialogButtonBox::ActionRole);
    copy->setObjectName(QStringLiteral("copy_report"));
    connect(copy, &QPushButton::clicked, this, [report] { QApplication::clipboard()->setText(report); });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(16, 16, 16, 14);
    column->setSpacing(10);
    column->addWidget(words);
    column->addWidget(text, 1);
    column->addWidget(place);
    column->addWidget(buttons);
    resize(720, 480);
}

}  // namespace pastoso::dialogs
