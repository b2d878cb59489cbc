#include "panels/canvas/illuminant_box.hpp"

#include "appearance/terms.hpp"
#include "panels/parts/section.hpp"

#include <QFileInfo>

namespace pastoso::panels {

IlluminantBox::IlluminantBox(QWidget* parent) : QComboBox(parent) {
    setAccessibleName(tr("Seen in"));
    setToolTip(tr("The light on the easel; the paint stays as it is"));
    addItem(tr("Daylight (D65)"), QStringLiteral("D65"));
    addItem(tr("Print booth (D50)"), QStringLiteral("D50"));
    addItem(tr("Light bulb (A)"), QStringLiteral("A"));
    addItem(tr("LED lamp"), QStringLiteral("LED"));
    addItem(tr("From a file..."), QString());
    for (const char* name : {"D65", "D50", "A"})
        setItemData(findData(QLatin1String(name)),
                    appearance::explanation(appearance::Term::StandardLights), Qt::ToolTipRole);
    keep_keys_for_canvas(this);
    connect(this, &QComboBox::activated, this, [this](int index) {
        const QString name = itemData(index).toString();
        if (name.isEmpty())
            Q_EMIT file_wanted();
        else
            Q_EMIT chosen(name);
    });
}

void IlluminantBox::show_illuminant(const QString& name_or_path) {
    int item = findData(name_or_path);
    if (item < 0) {
        item = count() - 1;
        insertItem(item, QFileInfo(name_or_path).completeBaseName(), name_or_path);
    }
    setCurrentIndex(item);
}

}  // namespace pastoso::panels
