// What the painter was told, and what stands until it is solved.
#pragma once

#include <functional>
#include <vector>

#include <QObject>
#include <QString>

namespace pastoso::panels {

/// What a message that stands is about. Of each matter one stands at most.
enum class Matter { Journal, Saving, Export, Opening, Notes, Screen, Colours };

struct StandingMessage {
    Matter matter{};
    QString sentence{};
    QString remedy_words{};          ///< of a button beside it; empty: none
    std::function<void()> remedy{};  ///< what the button does
};

class MessageLog : public QObject {
    Q_OBJECT
  public:
    explicit MessageLog(QObject* parent = nullptr);

    /// Tells a sentence, which passes.
    void add(const QString& sentence);

    /// Tells one that stands, in place of what stood of its matter, until the matter is solved. Told
    /// once where the same sentence stands already.
    void raise(const StandingMessage& message);

    /// Nothing stands of that matter any more; whether something did.
    bool solve(Matter matter);

    /// In the order of the matters.
    const std::vector<StandingMessage>& standing() const { return standing_; }

  Q_SIGNALS:
    void added(const QString& sentence);   ///< any
    void passed(const QString& sentence);  ///< one that does not stand
    void standing_changed();

  private:
    std::vector<StandingMessage> standing_;
};

}  // namespace pastoso::panels
