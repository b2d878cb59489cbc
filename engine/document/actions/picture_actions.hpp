// Pictures that are put onto the canvas as paint, or below it to be traced.
#pragma once

#include "document/actions/pen_actions.hpp"
#include "document/actions/table.hpp"
#include "document/layer_look.hpp"
#include "layers/picture_place.hpp"
#include "pigment/image.hpp"

#include <memory>
#include <string>

namespace pastoso::document {

struct LivingPainting;

inline constexpr double kLeastPicture_mm = 0.1;

/// Few bytes of a recording can unfold to many pixels, and a recording can hold many pictures.
inline constexpr double kMostRecordedPixels = 5e8;

using SharedPicture = std::shared_ptr<const pigment::Picture>;

/// Adds a layer above the active one that holds the picture as dry paint (layers/flat_paint.hpp), and
/// makes it active. Its paint comes out of the tubes.
struct PaintPicture {
    std::string name;            ///< of the layer
    layers::PicturePlace place;  ///< sides of 0.1 to 20000 mm; may reach beyond the canvas
    /// Not null; 1 to pigment::kMostPictureSide_px a side, pigment::kMostPicturePixels in all.
    SharedPicture picture;
    bool joins = false;  ///< the undo step before it, where a picture was put on a layer there, too

    friend bool operator==(const PaintPicture& a, const PaintPicture& b) {
        return a.name == b.name && a.place == b.place && a.joins == b.joins &&
               (a.picture == b.picture || *a.picture == *b.picture);
    }
};

/// Lays a picture below the paint to be traced, in place of the one before, or takes that away. It is
/// seen in the window alone, and is no paint.
struct LayTracing {
    SharedPicture picture;       ///< as in PaintPicture; null: none
    layers::PicturePlace place;  ///< as in PaintPicture

    friend bool operator==(const LayTracing& a, const LayTracing& b) {
        return a.place == b.place &&
               (a.picture == b.picture || (a.picture && b.picture && *a.picture == *b.picture));
    }
};
/// Where the tracing picture lies, and how strongly it shows. Nothing happens where there is none.
struct SetTracing {
    layers::PicturePlace place;
    double opacity = 0.5;  ///< 0 to 1
    friend bool operator==(const SetTracing&, const SetTracing&) = default;
};

using PictureActions = ActionList<PaintPicture, LayTracing, SetTracing>;

bool changes_anything(const LayTracing& lay, const LivingPainting& painting);
bool changes_anything(const SetTracing& set, const LivingPainting& painting);
/// Throws InputError where it has more pixels than a recording may hold.
void check_picture(const pigment::Picture& picture);
void check_whole(const PaintPicture& paint);
void check_whole(const LayTracing& lay);
void apply(const PaintPicture& paint, LivingPainting& painting);
void apply(const LayTracing& lay, LivingPainting& painting);
void apply(const SetTracing& set, LivingPainting& painting);

template <>
struct Table<layers::PicturePlace> {
    static constexpr void fields(auto&& visit) {
        using Place = layers::PicturePlace;
        using enum Presence;
        constexpr double kFar_mm = kMaxPenPosition_mm;
        visit(Number<At<&Place::x_mm>>{"x_mm", core::Pattern<0>("x of the picture"), "mm", -kFar_mm,
                                       kFar_mm, Required, "of its upper left corner"});
        visit(Number<At<&Place::y_mm>>{"y_mm", core::Pattern<0>("y of the picture"), "mm", -kFar_mm,
                                       kFar_mm, Required});
        visit(Number<At<&Place::width_mm>>{"width_mm", core::Pattern<0>("width of the picture"), "mm",
                                           kLeastPicture_mm, kFar_mm, Required});
        visit(Number<At<&Place::height_mm>>{"height_mm", core::Pattern<0>("height of the picture"), "mm",
                                            kLeastPicture_mm, kFar_mm, Required});
    }
};

template <>
struct Table<PaintPicture> {
    static constexpr ActionTraits kTraits = change(
        "paint_picture", 6, step_name("Picture as paint"),
        "adds a layer above the active one, which becomes active, and puts a picture on it as thin, "
        "dry paint ([0031](decisions/0031-pictures.md))");
    static constexpr UndoRole undo_role(const PaintPicture& paint) {
        return paint.joins ? UndoRole::MaybeStep : UndoRole::Step;
    }
    static constexpr void fields(auto&& visit) {
        visit(Part<At<&PaintPicture::place>>{});
        visit(Text<At<&PaintPicture::name>>{"name", core::Pattern<0>("name of a layer"), kMostLayerName,
                                            Presence::Required});
        visit(Value<At<&PaintPicture::picture>>{
            "png", "picture", Presence::Required,
            "a PNG file in base64: sRGB, with or without transparency, at most 32 768 pixels a side, "
            "100 million in all, 500 million in a recording"});
        visit(Truth<At<&PaintPicture::joins>>{
            .key = "joins",
            .name = "joins",
            .presence = Presence::Optional,
            .note = "part of the undo step before it, where that put a picture on a layer, too",
            .since = 16});
    }
};

template <>
struct Table<LayTracing> {
    static constexpr ActionTraits kTraits = possible_change(
        "lay_tracing", 7, step_name("Picture to trace"),
        "the picture lies below the paint to be traced, in place of the one before; `{}` takes that "
        "away. It is no paint, and in no picture of the painting");
    /// An action without a picture is told by an empty object.
    static constexpr bool kEmptyIsDefault = true;
    static UndoRole undo_role(const LayTracing& lay) {
        return lay.picture ? UndoRole::Step : UndoRole::MaybeStep;
    }
    static constexpr void fields(auto&& visit) {
        visit(Part<At<&LayTracing::place>>{});
        visit(Value<At<&LayTracing::picture>>{
            "png", "picture", Presence::Required,
            "a PNG file in base64: sRGB, with or without transparency, at most 32 768 pixels a side, "
            "100 million in all, 500 million in a recording"});
    }
};

template <>
struct Table<SetTracing> {
    static constexpr ActionTraits kTraits =
        possible_change("set_tracing", 7, step_name("Place of the traced picture"),
                        "where the picture that is traced lies from now on, and how strongly it shows");
    static constexpr void fields(auto&& visit) {
        visit(Part<At<&SetTracing::place>>{});
        visit(Number<At<&SetTracing::opacity>>{"opacity",
                                               core::Pattern<0>("opacity of the tracing picture"), "",
                                               0.0, 1.0, Presence::Required, "0.5 for the first"});
    }
};

}  // namespace pastoso::document
