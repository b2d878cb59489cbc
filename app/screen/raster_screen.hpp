// A canvas drawn by the processor, where OpenGL is not to be had: slower, and complete.
#pragma once

#include "core/worker.hpp"
#include "screen/canvas_screen.hpp"
#include "screen/drawing_threads.hpp"
#include "screen/raster_picture.hpp"

#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include <QTimer>

namespace pastoso::screen {

class RasterScreen : public QWidget, public CanvasScreen {
    Q_OBJECT
  public:
    RasterScreen(ScreenHost& host, QWidget& parent);

    QWidget& widget() override { return *this; }
    void refresh() override;
    void begin_other_canvas() override;
    void damage_all() override;
    bool finished() const override;
    const document::Snapshot* shown() const override;
    QImage picture() override;

  protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;

  private:
    /// Pixels of the picture. All of it, shared with who makes the next one, would be copied each time.
    struct PicturePart {
        QPoint place;
        QImage pixels;
    };

    /// A scene, and what its picture has that the one before had not once that is made.
    struct Frame {
        RasterScene scene;
        bool refines = false;  ///< the picture that is there already
        bool is_draft = false, is_drafted_now = false;
        std::vector<PicturePart> changed{};  ///< since the frame before
        double scale_top_mm = 0.0;
        core::Message fault{};  ///< in one sentence, instead of the picture
    };

    RasterScene wanted_scene() const;
    void make(Frame& frame);
    void hand_over(Frame frame);
    void take_frame();
    QRegion put_in(const Frame& made);
    void refine();
    bool is_where_it_is_seen() const;
    QRect overlay_points() const;
    void look_at_overlay();
    void update_overlay();
    void update_picture(const QRegion& changed_px);
    void draw(QPainter& painter);

    ScreenHost& host_;
    core::ThreadPool& pool_ = drawing_threads();
    RasterPicture picture_;  ///< the worker's
    std::optional<RasterScene> asked_;
    std::optional<Frame> frame_;  ///< on the screen
    QImage shown_;                ///< its picture
    QTimer rest_;                 ///< since a draft was made
    QRect overlay_;               ///< what is drawn over it lies there, in points
    bool looks_at_overlay_ = false;
    std::mutex mutex_;
    std::optional<Frame> made_;   ///< and not on it yet
    core::Worker<Frame> worker_;  ///< the last: it ends before what it works with
};

}  // namespace pastoso::screen
