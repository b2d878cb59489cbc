// A painting that was made beside the window, as it waits for the easel.
#pragma once

#include "core/thread.hpp"
#include "journal/journal_writer.hpp"
#include "session/paint_session.hpp"

#include <cstdint>
#include <filesystem>
#include <future>
#include <memory>
#include <string>

namespace pastoso::main {

/// Where a painting's journal is kept, and who is told of trouble with it.
struct JournalTerms {
    std::filesystem::path root{};  ///< empty: nowhere
    journal::JournalWriter::Told told{};
    std::uint64_t number = 0;  ///< of the journal; the latest on the easel is the one in use
};

/// A painting with the pool that it was made with, and what was done to it before.
struct MadePainting {
    std::unique_ptr<core::ThreadPool> pool;
    std::unique_ptr<document::Painting> painting;
    document::Recording past{};
};

struct PreparedPainting {
    MadePainting made;
    std::uint64_t journal_number = 0;
    session::PaintSession::BeginJournal begin_journal{};
    std::unique_ptr<journal::JournalWriter> journal{};
    core::Message journal_fault{};  ///< why there is none yet

    /// On any thread. A painting that cannot be kept in a journal is painted nevertheless.
    PreparedPainting(MadePainting painting, journal::Beginning beginning, const JournalTerms& terms);
    /// Of a painting that never came to the easel nothing needs to be recovered.
    ~PreparedPainting();
    PreparedPainting(const PreparedPainting&) = delete;
    PreparedPainting& operator=(const PreparedPainting&) = delete;
};

using SharedPainting = std::shared_ptr<PreparedPainting>;

/// One of what a file or a replay gave.
MadePainting made_of(const document::PaintingState& painting, document::Recording past,
                     std::unique_ptr<core::ThreadPool> pool);
MadePainting bare_painting(const document::CanvasSettings& canvas);

/// The first canvas of a window, made on a thread of its own while the window is laid out.
class FirstCanvas {
  public:
    /// Begins to make it.
    explicit FirstCanvas(const document::CanvasSettings& canvas);

    /// Waits for it, once. Throws core::InputError when there can be no such canvas.
    MadePainting take() { return made_.get(); }

  private:
    std::packaged_task<MadePainting()> make_;
    std::future<MadePainting> made_;
    core::Thread thread_;
};

}  // namespace pastoso::main
