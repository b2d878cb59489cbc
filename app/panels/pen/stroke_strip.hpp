// A strip with a stroke of a tool, painted by the engine: roughly at once, and finely when it rests.
#pragma once

#include "brush/preset.hpp"
#include "session/sample_painter.hpp"

#include <QImage>
#include <QTimer>
#include <QWidget>

namespace pastoso::panels {

class StrokeStrip : public QWidget {
    Q_OBJECT
  public:
    /// `tell` hears, on any thread, why a stroke is missing.
    explicit StrokeStrip(core::Tell tell, QWidget* parent = nullptr);

    /// Shows that mark of the tool on a board of which the height holds one of this width.
    void show_tool(const brush::Preset& preset, document::ToolMark mark, double mark_mm);

    /// Stands in its corner; none at first.
    void set_caption(const QString& caption);

    /// As it was delivered last.
    const QImage& picture() const { return picture_; }

    QSize sizeHint() const override { return {600, 108}; }
    QSize minimumSizeHint() const override { return {200, 72}; }

  Q_SIGNALS:
    /// `fine`: nothing follows until something changes.
    void painted(bool fine);

  protected:
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

  private:
    void begin();
    void want(bool fine);
    void take(int number, const QImage& image);
    double board_mm() const;
    void paint_scale(QPainter& painter) const;
    void paint_words(QPainter& painter, const QRectF& room, int alignment, const QString& words) const;

    brush::Preset preset_;
    document::ToolMark mark_{};
    double mark_mm_ = 0.0;  ///< 0: there is no tool yet
    QString caption_;
    QImage picture_;
    QTimer resting_;
    int latest_ = 0;     ///< number of the sample that was asked for last
    bool fine_ = false;  ///< it is a fine one
    session::SamplePainter painter_;
};

}  // namespace pastoso::panels
