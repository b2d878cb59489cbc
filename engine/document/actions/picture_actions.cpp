#include "document/actions/picture_actions.hpp"

#include "core/check.hpp"
#include "document/actions/field_checks.hpp"
#include "document/living_painting.hpp"

#include <memory>

namespace pastoso::document {
namespace {

void trace(layers::Tracing tracing, LivingPainting& painting) {
    painting.value.tracing = std::make_shared<const layers::Tracing>(std::move(tracing));
}

}  // namespace

void check_picture(const pigment::Picture& picture) {
    const int width = picture.width, height = picture.height;
    constexpr core::Pattern<0> kUnit = core::Pattern<0>("pixels");
    check_between(core::message("width of the picture"), kUnit, width, 1, pigment::kMostPictureSide_px);
    check_between(core::message("height of the picture"), kUnit, height, 1,
                  pigment::kMostPictureSide_px);
    check_between(core::message("number of the picture's pixels"), "", 1.0 * width * height, 1,
                  pigment::kMostPicturePixels);
    PASTOSO_CHECK_OP(picture.rgba.size(), ==, std::size_t{4} * width * height);
}

void check_whole(const PaintPicture& paint) {
    PASTOSO_CHECK(paint.picture != nullptr);
    check_picture(*paint.picture);
}

void check_whole(const LayTracing& lay) {
    PASTOSO_CHECK(lay.picture != nullptr);
    check_picture(*lay.picture);
}

bool changes_anything(const LayTracing& lay, const LivingPainting& painting) {
    return lay.picture || painting.value.tracing;
}

bool changes_anything(const SetTracing&, const LivingPainting& painting) {
    return painting.value.tracing != nullptr;
}

void apply(const PaintPicture& paint, LivingPainting& painting) {
    painting.value.flows.taken += painting.contents_of(painting.canvas.paint_picture(paint));
}

void apply(const LayTracing& lay, LivingPainting& painting) {
    const SharedTracing& before = painting.value.tracing;
    if (lay.picture)
        trace({lay.picture, lay.place, before ? before->opacity : layers::Tracing{}.opacity}, painting);
    else
        painting.value.tracing.reset();
}

void apply(const SetTracing& set, LivingPainting& painting) {
    trace({painting.value.tracing->picture, set.place, set.opacity}, painting);
}

}  // namespace pastoso::document
