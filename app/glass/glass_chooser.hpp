// What is in the glass: milk tea, a tank that comes with the program, or one from a file.
#pragma once

#include <QComboBox>

namespace pastoso::glass {

class GlassChooser : public QComboBox {
    Q_OBJECT
  public:
    explicit GlassChooser(QWidget* parent = nullptr);

    static QString tea_key() { return QStringLiteral("tea"); }

    /// Shows this one as chosen, without a signal: tea_key(), the name of a tank that comes with the
    /// program, or the path of a file.
    void show_choice(const QString& key);
    QString choice() const { return currentData().toString(); }

  Q_SIGNALS:
    /// The same keys; empty where a file is to be asked for.
    void chosen(const QString& key);

  private:
    QString shown_;
};

/// What a tank is called in the language of the window: one that comes with the program by its name in
/// files, any other as its scene or its file is called.
QString tank_words(const QString& key);

}  // namespace pastoso::glass
