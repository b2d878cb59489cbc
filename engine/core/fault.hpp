// The edge of a thread, a program or an event: no exception passes it, and the user reads one sentence.
#pragma once

#include "core/message.hpp"

#include <functional>
#include <utility>

namespace pastoso::core {

/// Is told in one sentence what went wrong, on any thread; must return at once.
using Tell = std::function<void(const Message& sentence)>;

/// One sentence on the exception that is being handled: an InputError's own; of another one of the
/// system the files it names and the system's reason; that memory ran out; or that the program is at
/// fault. To be called where one is being handled.
Message caught_fault() noexcept;

/// Calls work(). Returns one sentence on what it threw, and nothing when it threw nothing.
template <class Work>
Message fault_of(Work&& work) noexcept {
    try {
        std::forward<Work>(work)();
        return {};
    } catch (...) {
        return caught_fault();
    }
}

/// Calls work(), and tell(sentence) with one sentence on what it threw. What tell() throws in turn is
/// dropped: nobody is left who could be told.
template <class Work, class Told>
void guarded(Work&& work, const Told& tell) noexcept {
    const Message sentence = fault_of(std::forward<Work>(work));
    if (!sentence.empty()) fault_of([&] { tell(sentence); });
}

}  // namespace pastoso::core
