#include "glass/glass_chooser.hpp"

#include "glass/panel_parts.hpp"
#include "liquid_files/tank_json.hpp"
#include "panels/parts/section.hpp"

#include <utility>

#include <QFileInfo>
#include <QSignalBlocker>

namespace pastoso::glass {
namespace {

constexpr std::pair<const char*, const char*> kTanks[] = {
    {"falling-liquid", QT_TR_NOOP("Tank: liquid falls")},
    {"two-liquids", QT_TR_NOOP("Tank: two liquids meet")},
};

}  // namespace

QString tank_words(const QString& key) {
    for (const auto& [name, words] : kTanks)
        if (key == QLatin1String(name)) return words_of(words);
    return QFileInfo(key).completeBaseName();
}

GlassChooser::GlassChooser(QWidget* parent) : QComboBox(parent) {
    setObjectName(QStringLiteral("glass_chooser"));
    setAccessibleName(tr("What is in the glass"));
    setToolTip(tr("What is in the glass: milk tea, or a tank of liquid"));
    setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    addItem(tr("Milk tea"), tea_key());
    for (const std::string& name : liquid_files::bundled_tank_names()) {
        const QString key = QString::fromStdString(name);
        addItem(tank_words(key), key);
    }
    addItem(tr("Open a tank..."), QString());
    panels::keep_keys_for_canvas(this);
    // Who asks for a file and then wants none stays with what is there.
    connect(this, &QComboBox::activated, this, [this] {
        const QString key = choice();
        if (key.isEmpty()) show_choice(shown_);
        Q_EMIT chosen(key);
    });
}

void GlassChooser::show_choice(const QString& key) {
    const QSignalBlocker quiet(this);
    if (findData(key) < 0) insertItem(count() - 1, tank_words(key), key);
    setCurrentIndex(findData(key));
    shown_ = key;
}

}  // namespace pastoso::glass
