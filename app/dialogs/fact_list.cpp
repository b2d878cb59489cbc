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

QWidget* fact_list(const std::vector<Fact>& facts) {
    auto* page = new QWidget;
    auto* form = new QFormLayout(page);
    form->setContentsMargins(16, 16, 16, 16);
    form->setHorizontalSpacing(16);
    form->setVerticalSpacing(10);
    QString all;
    for (const auto& [what, how] : facts) {
        auto* value = new QLabel(how);
        value->setTextInteractionFlags(Qt::TextSelectableByMouse);
        value->setWordWrap(true);
        form->addRow(what, value);
        all += QStringLiteral("%1: %2\n").arg(what, how);
    }
    auto* copy = new QPushButton(Words::tr("Copy"));
    copy->setObjectName(QStringLiteral("copy_facts"));
    QObject::connect(copy, &QPushButton::clicked, copy,
                     [all] { QApplication::clipboard()->setText(all); });
    auto* row = new QHBoxLayout;
    row->addStretch();
    row->addWidget(copy);
    form->addRow(row);
    return page;
}

}  // namespace pastoso::dialogs
