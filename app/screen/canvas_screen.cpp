#include "screen/canvas_screen.hpp"

#include "graphics/opengl_support.hpp"
#include "screen/gl_screen.hpp"
#include "screen/raster_screen.hpp"

namespace pastoso::screen {

std::unique_ptr<CanvasScreen> make_screen(DrawnBy drawn_by, ScreenHost& host, QWidget& parent) {
    const graphics::OpenGlSupport& opengl = graphics::opengl_support();
    const bool by_processor = !opengl.problem.empty() || drawn_by == DrawnBy::Processor ||
                              (drawn_by == DrawnBy::Fastest && opengl.software);
    if (by_processor) return std::make_unique<RasterScreen>(host, parent);
    return std::make_unique<GlScreen>(host, parent);
}

}  // namespace pastoso::screen
