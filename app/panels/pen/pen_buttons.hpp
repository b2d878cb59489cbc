// What the ends and buttons of pens do.
#pragma once

#include "tools/pen_settings.hpp"

#include <QWidget>

class QComboBox;

namespace pastoso::panels {

class PenButtons : public QWidget {
    Q_OBJECT
  public:
    explicit PenButtons(const tools::PenSettings& settings, QWidget* parent = nullptr);

    /// One of PenSettings' buttons.
    using Button = tools::PenButtonDoes tools::PenSettings::*;

  Q_SIGNALS:
    void eraser_chosen(const QString& tool);  ///< empty: the end paints like the tip
    void button_chosen(Button button, tools::PenButtonDoes what);

  private:
    QComboBox* eraser_choice(const std::string& chosen);
    QComboBox* button_choice(const char* name, Button button, tools::PenButtonDoes chosen);
};

}  // namespace pastoso::panels
