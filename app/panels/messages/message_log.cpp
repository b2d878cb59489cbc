#include "panels/messages/message_log.hpp"

#include <algorithm>

namespace pastoso::panels {

MessageLog::MessageLog(QObject* parent) : QObject(parent) {}

void MessageLog::add(const QString& sentence) {
    Q_EMIT added(sentence);
    Q_EMIT passed(sentence);
}

void MessageLog::raise(const StandingMessage& message) {
    const auto place = std::ranges::lower_bound(standing_, message.matter, {}, &StandingMessage::matter);
    const bool stands = place != standing_.end() && place->matter == message.matter;
    if (stands && place->sentence == message.sentence) return;
    if (stands)
        *place = message;
    else
        standing_.insert(place, message);
    Q_EMIT added(message.sentence);
    Q_EMIT standing_changed();
}

bool MessageLog::solve(Matter matter) {
    if (std::erase_if(standing_, [&](const auto& message) { return message.matter == matter; }) == 0)
        return false;
    Q_EMIT standing_changed();
    return true;
}

}  // namespace pastoso::panels
