#include "panels/paint/tube_menu.hpp"

#include "panels/parts/section.hpp"

#include <QAction>
#include <QMenu>

namespace pastoso::panels {

TubeMenu::TubeMenu(QWidget* parent) : QToolButton(parent) {
    setObjectName(QStringLiteral("tube_sets"));
    setAutoRaise(true);
    setPopupMode(QToolButton::InstantPopup);
    setToolTip(tr("Which tubes are shown: all of them, or a set of yours"));
    setMenu(new QMenu(this));
    keep_keys_for_canvas(this);
    connect(menu(), &QMenu::aboutToShow, this, &TubeMenu::fill);
    show_sets({}, {});
}

void TubeMenu::show_sets(const QStringList& names, const QString& chosen) {
    constexpr int kMostWidth = 80;
    names_ = names;
    chosen_ = chosen;
    const QString words = chosen.isEmpty() ? tr("All tubes") : chosen;
    setText(fontMetrics().elidedText(words, Qt::ElideRight, kMostWidth));
    setAccessibleName(words);
}

void TubeMenu::fill() {
    menu()->clear();
    const auto add_choice = [this](const QString& words, const QString& name) {
        QAction* choice = menu()->addAction(words, this, [this, name] { Q_EMIT chosen_set(name); });
        choice->setCheckable(true);
        choice->setChecked(name == chosen_);
    };
    add_choice(tr("All tubes"), QString());
    for (const QString& name : names_)
        add_choice(QString(name).replace('&', QLatin1String("&&")), name);
    menu()->addSeparator();
    menu()->addAction(tr("Save as a set..."), this, &TubeMenu::save_wanted);
    QAction* rename = menu()->addAction(tr("Rename the set..."), this, &TubeMenu::rename_wanted);
    QAction* remove = menu()->addAction(tr("Remove the set"), this, &TubeMenu::removal_wanted);
    for (QAction* action : {rename, remove})
        action->setEnabled(!chosen_.isEmpty());
    menu()->addSeparator();
    menu()->addAction(tr("Import sets..."), this, &TubeMenu::import_wanted);
    menu()
        ->addAction(tr("Export my sets..."), this, &TubeMenu::export_wanted)
        ->setEnabled(!names_.isEmpty());
    menu()->addSeparator();
    menu()
        ->addAction(tr("Squeeze these onto the mixing well"), this, &TubeMenu::squeeze_wanted)
        ->setEnabled(!chosen_.isEmpty());
    menu()->addAction(tr("Squeeze out the last painting's palette"), this,
                      &TubeMenu::last_palette_wanted);
}

}  // namespace pastoso::panels
