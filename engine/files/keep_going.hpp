// Long work on files tells how far it is, and can be stopped.
#pragma once

#include <functional>

namespace pastoso::files {

/// How an export ended. Stopped: every file is as it was before.
enum class ExportStatus { Written, Stopped };

/// Is told the share that is done, 0 to 1, now and then; returns false to stop.
using KeepGoing = std::function<bool(double done)>;

}  // namespace pastoso::files
