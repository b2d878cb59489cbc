// How hard a mouse presses, which cannot tell it.
#pragma once

#include "tools/pen_settings.hpp"

#include <QWidget>

namespace pastoso::panels {

class MousePart : public QWidget {
    Q_OBJECT
  public:
    explicit MousePart(const tools::MouseSettings& mouse, QWidget* parent = nullptr);

  Q_SIGNALS:
    void changed(const pastoso::tools::MouseSettings& mouse);

  private:
    tools::MouseSettings mouse_;
};

}  // namespace pastoso::panels
