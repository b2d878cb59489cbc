#include "panels/history/step_words.hpp"

#include "appearance/shown_names.hpp"

#include <QObject>

namespace pastoso::panels {

using Kind = document::Step::Kind;

QString step_words(const document::Step& step) {
    switch (step.kind) {
        case Kind::Stroke:
            return QObject::tr("Stroke");
        case Kind::StrokeInWell:
            return QObject::tr("Stroke in the mixing well");
        case Kind::DryNow:
            return QObject::tr("Dry now");
        case Kind::SqueezePaint:
            return QObject::tr("Paint squeezed out");
        case Kind::CleanWell:
            return QObject::tr("Mixing well wiped");
        case Kind::AddLayer:
            return QObject::tr("New layer");
        case Kind::SetLayer:
            return QObject::tr("Look of a layer");
        case Kind::DuplicateLayer:
            return QObject::tr("Layer duplicated");
        case Kind::RemoveLayer:
            return QObject::tr("Layer removed");
        case Kind::ClearLayer:
            return QObject::tr("Layer cleared");
        case Kind::TransformLayer:
            return QObject::tr("Transform");
        case Kind::MoveLayer:
            return QObject::tr("Layer moved");
        case Kind::MergeDown:
            return QObject::tr("Merged down");
        case Kind::FlattenLayers:
            return QObject::tr("Flattened");
        case Kind::GroupLayers:
            return QObject::tr("Layers grouped");
        case Kind::SetGroup:
            return QObject::tr("Look of a group");
        case Kind::MoveGroup:
            return QObject::tr("Group moved");
        case Kind::UngroupLayers:
            return QObject::tr("Group dissolved");
        case Kind::Select:
            return QObject::tr("Selection");
        case Kind::ResizeCanvas:
            return QObject::tr("Size of the canvas");
        case Kind::PaintPicture:
            return QObject::tr("Picture as paint");
        case Kind::LayTracing:
            return QObject::tr("Picture to trace");
        case Kind::SetTracing:
            return QObject::tr("Place of the traced picture");
    }
    return {};
}

QString step_detail(const document::Step& step) {
    return appearance::shown_name(step.brush.empty() ? step.layer : step.brush);
}

}  // namespace pastoso::panels
