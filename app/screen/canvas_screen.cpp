#include "screen/canvas_screen.hpp"

#include "graphics/opengl_support.hpp"
#include "screen/gl_screen.hpp"
#include "screen/raster_screen.hpp"

namespace pastoso::screen {

bool drawn_by_processor(DrawnBy drawn_by, const graphics::OpenGlSupport& opengl, double cells) {
    constexpr double kMostInTextures = 32e6;
    if (!opengl.problem.empty() || drawn_by == DrawnBy::Processor) return true;
    return drawn_by == DrawnBy::Fastest && (opengl.software || cells > kMostInTextures);
}

std::unique_ptr<CanvasScreen> make_screen(DrawnBy drawn_by, ScreenHost& host, QWidget& parent) {
    if (drawn_by_processor(drawn_by, graphics::opengl_support(), 0.0))
        return std::make_unique<RasterScreen>(host, parent);
    return std::make_unique<GlScreen>(host, parent);
}

}  // namespace pastoso::screen
