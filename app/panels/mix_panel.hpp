// A paint for a picked colour, and the recipe of tubes that comes nearest to it.
#pragma once

#include <QColor>
#include <QString>
#include <QWidget>

class QColorDialog;
class QLabel;
class QPushButton;

namespace pastoso::panels {

class MixPanel : public QWidget {
    Q_OBJECT
  public:
    explicit MixPanel(QWidget* parent = nullptr);

    /// Shows a colour that was picked, and its closest recipe with the difference in CIEDE2000.
    void show_recipe(const QColor& colour, const QString& recipe, double difference);

    /// Which of the two the brush is dipped in; neither when it is a paint from a tube.
    enum class Dipped { Neither, Colour, Recipe };
    void show_dipped(Dipped dipped);

  Q_SIGNALS:
    void colour_picked(const QColor& colour);
    void recipe_wanted();

  private:
    void ask_colour();

    QColor colour_ = QColor(0xc0, 0x30, 0x20);
    QColorDialog* dialog_ = nullptr;
    QLabel* recipe_ = nullptr;
    QPushButton* use_recipe_ = nullptr;
};

}  // namespace pastoso::panels
