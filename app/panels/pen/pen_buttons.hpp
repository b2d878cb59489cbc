// What the ends and buttons of pens do, and fingers; what runs ahead of the brush.
#pragma once

#include "tools/pen_settings.hpp"

#include <QWidget>

class QComboBox;

namespace pastoso::panels {

class PenButtons : public QWidget {
    Q_OBJECT
  public:
    explicit PenButtons(const tools::PenSettings& settings, QWidget* parent = nullptr);

  Q_SIGNALS:
    void eraser_chosen(const QString& tool);  ///< empty: the end paints like the tip
    void button_chosen(tools::PenButton button, const tools::PenAction& action);
    void fingers_chosen(bool paint);
    void mark_chosen(bool at_once);

  private:
    QComboBox* eraser_choice(const std::string& chosen);
    QComboBox* button_choice(const char* name, tools::PenButton button, const tools::PenAction& chosen);
};

}  // namespace pastoso::panels
