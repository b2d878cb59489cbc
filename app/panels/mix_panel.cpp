#include "panels/mix_panel.hpp"

#include "panels/section.hpp"

#include <QColorDialog>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace pastoso::panels {
namespace {

QString difference_words(double difference) {
    if (difference < 1.0) return QObject::tr("the same to the eye");
    if (difference < 2.5) return QObject::tr("close");
    if (difference < 6.0) return QObject::tr("a little off");
    return QObject::tr("beyond these tubes");
}

}  // namespace

MixPanel::MixPanel(QWidget* parent)
    : QWidget(parent), recipe_(new QLabel), use_recipe_(new QPushButton(tr("Use the recipe"))) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(6);
    auto* pick = new QPushButton(tr("Mix a colour..."));
    pick->setObjectName(QStringLiteral("mix_colour"));
    pick->setToolTip(tr("A paint of any colour, and which tubes come nearest to it"));
    use_recipe_->setObjectName(QStringLiteral("use_recipe"));
    use_recipe_->setToolTip(tr("Dip the brush in this mixture from the tubes instead"));
    recipe_->setObjectName(QStringLiteral("recipe"));
    recipe_->setWordWrap(true);
    recipe_->setTextFormat(Qt::RichText);
    for (QPushButton* button : {pick, use_recipe_})
        keep_keys_for_canvas(button);
    for (QWidget* widget : {static_cast<QWidget*>(pick), static_cast<QWidget*>(recipe_),
                            static_cast<QWidget*>(use_recipe_)})
        column->addWidget(widget);
    recipe_->hide();
    use_recipe_->hide();
    connect(pick, &QPushButton::clicked, this, &MixPanel::ask_colour);
    connect(use_recipe_, &QPushButton::clicked, this, &MixPanel::recipe_wanted);
}

/// The dialog stays open beside the canvas, so that a colour can be compared with the painting.
void MixPanel::ask_colour() {
    if (dialog_ == nullptr) {
        dialog_ = new QColorDialog(this);
        dialog_->setOption(QColorDialog::DontUseNativeDialog);
        dialog_->setWindowTitle(tr("Mix a colour"));
        connect(dialog_, &QColorDialog::colorSelected, this, &MixPanel::colour_picked);
    }
    dialog_->setCurrentColor(colour_);
    dialog_->show();
    dialog_->raise();
}

void MixPanel::show_recipe(const QColor& colour, const QString& recipe, double difference) {
    colour_ = colour;
    recipe_->setText(tr("<span style=\"color:%1\">&#9632;</span> %1<br>nearest: %2<br>ΔE %3, %4")
                         .arg(colour.name(), recipe.toHtmlEscaped(), QString::number(difference, 'f', 1),
                              difference_words(difference)));
    recipe_->show();
    use_recipe_->show();
}

void MixPanel::show_dipped(Dipped dipped) {
    use_recipe_->setEnabled(dipped != Dipped::Recipe);
    recipe_->setVisible(dipped != Dipped::Neither);
    use_recipe_->setVisible(dipped != Dipped::Neither);
}

}  // namespace pastoso::panels
