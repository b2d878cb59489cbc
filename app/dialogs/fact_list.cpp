#include "dialogs/fact_list.hpp"

#include <QApplication>
#include <QClipboard>
#include <QCoreApplication>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

namespace pastoso::dialogs {
namespace {

/// Makes tr() find these words.
struct Words {
    Q_DECLARE_TR_FUNCTIONS(FactList)
};

}  // namespace

QString words_of(const std::vector<Fact>& facts) {
    QString words;
    for (const auto& [what, how] : facts)
        words += QStringLiteral("%1: %2\n").arg(what, how);
    return words;
}

QWidget* fact_list(const std::vector<Fact>& facts) {
    auto* page = new QWidget;
    auto* form = new QFormLayout(page);
    form->setContentsMargins(16, 16, 16, 16);
    form->setHorizontalSpacing(16);
    form->setVerticalSpacing(10);
    for (const auto& [what, how] : facts) {
        auto* value = new QLabel(how);
        value->setTextInteractionFlags(Qt::TextSelectableByMouse);
        value->setWordWrap(true);
        form->addRow(what, value);
    }
    auto* copy = new QPushButton(Words::tr("Copy"));
    copy->setObjectName(QStringLiteral("copy_facts"));
    QObject::connect(copy, &QPushButton::clicked, copy,
                     [facts] { QApplication::clipboard()->setText(words_of(facts)); });
    auto* row = new QHBoxLayout;
    row->addStretch();
    row->addWidget(copy);
    form->addRow(row);
    return page;
}

}  // namespace pastoso::dialogs
