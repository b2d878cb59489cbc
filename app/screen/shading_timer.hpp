// What shading costs the graphics card, which is asked without waiting for it.
#pragma once

#include <deque>
#include <memory>
#include <vector>

#include <QOpenGLTimerQuery>

namespace pastoso::screen {

/// All calls need the same current context. Measures nothing where the driver has no timer.
class ShadingTimer {
  public:
    /// What is drawn between the two shades so many samples.
    void begin();
    void end(double samples);

    struct Measured {
        double samples = 0.0, seconds = 0.0;
    };

    /// What has become known since the last call, a frame or more after it was drawn.
    std::vector<Measured> take_measured();

    void release();

  private:
    struct Asked {
        std::unique_ptr<QOpenGLTimerQuery> query;
        double samples = 0.0;
    };

    std::unique_ptr<QOpenGLTimerQuery> new_query();

    std::unique_ptr<QOpenGLTimerQuery> running_;
    std::deque<Asked> asked_;
    std::vector<std::unique_ptr<QOpenGLTimerQuery>> free_;
};

}  // namespace pastoso::screen
