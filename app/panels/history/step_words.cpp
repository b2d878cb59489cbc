#include "panels/history/step_words.hpp"

#include "appearance/shown_names.hpp"

#include <QCoreApplication>

namespace pastoso::panels {

QString step_words(const document::UndoStep& step) {
    return QCoreApplication::translate("pastoso::document::Table", step.name.data());
}

QString step_detail(const document::UndoStep& step) {
    return appearance::shown_name(step.brush.empty() ? step.layer : step.brush);
}

}  // namespace pastoso::panels
