// Tells the window of what other threads publish.
#pragma once

#include <functional>

class QObject;

namespace pastoso::main {

/// What any thread may call as often as it likes: `refresh` then runs on the thread of `receiver`, as
/// long as that lives. One call at a time waits in the event queue.
std::function<void()> queued_refresh(QObject* receiver, std::function<void()> refresh);

}  // namespace pastoso::main
