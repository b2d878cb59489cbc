// What Undo takes back and Redo does again, for people to recognise it.
#pragma once

#include <cstddef>
#include <string>

namespace pastoso::document {

struct Step {
    enum class Kind {
        Stroke,
        StrokeInWell,
        DryNow,
        SqueezePaint,
        CleanWell,
        AddLayer,
        SetLayer,
        DuplicateLayer,
        RemoveLayer,
        ClearLayer,
        TransformLayer,
        MoveLayer,
        MergeDown,
        FlattenLayers,
        GroupLayers,
        SetGroup,
        MoveGroup,
        UngroupLayers,
        Select,
        ResizeCanvas,
        PaintPicture,
        LayTracing,
        SetTracing
    };
    Kind kind = Kind::Stroke;
    std::string brush{};  ///< name of the preset; "" where none had a part in it
    std::string layer{};  ///< name that the layer or group had then; "" where it was no single one
    friend bool operator==(const Step&, const Step&) = default;
};

struct KeptStep {
    Step step{};
    std::size_t bytes = 0;  ///< that the moment before or after it holds alone
    bool packed = false;
};

}  // namespace pastoso::document
