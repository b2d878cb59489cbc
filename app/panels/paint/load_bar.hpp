// A picture of what the brush holds: its width from left to right, how full it is, and of which colour.
#pragma once

#include "brush/load_profile.hpp"
#include "tools/swatch.hpp"

#include <QWidget>

namespace pastoso::panels {

class LoadBar : public QWidget {
    Q_OBJECT
  public:
    explicit LoadBar(QWidget* parent = nullptr);

    void show_load(const brush::LoadProfile& load);
    void show_swatches(const tools::SwatchView& view);
    const brush::LoadProfile& load() const { return load_; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    brush::LoadProfile load_;
    tools::SwatchView view_;
};

}  // namespace pastoso::panels
