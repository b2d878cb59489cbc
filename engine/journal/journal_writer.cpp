#include "journal/journal_writer.hpp"

#include "core/disk.hpp"
#include "core/error.hpp"
#include "core/looking.hpp"
#include "core/version.hpp"
#include "journal/frames.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <iterator>
#include <span>
#include <unistd.h>
#include <utility>

namespace pastoso::journal {
namespace {

constexpr const char* kStartFile = "start.pastoso";

/// A batch of more is written in several frames: a frame stays small enough to be read.
constexpr std::size_t kMostBatchEvents = 4096;

/// Time that passes without actions is written four times a second while paint moves, and every ten
/// seconds while it rests.
constexpr std::int64_t kQuietTicks = 15, kRestTicks = 600;

Header header_of(const Beginning& beginning) {
    return {.program = core::version(),
            .painting = beginning.painting.string(),
            .start = beginning.write_start ? kStartFile : "",
            .start_tick = beginning.tick,
            .start_is_saved = beginning.is_saved};
}

core::Message refusal_of(const std::filesystem::path& path, int reason) {
    return core::message("%1: cannot be written (%2).", path.string(), std::strerror(reason));
}

int opened(const std::filesystem::path& path) {
    const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
    if (file < 0) throw core::InputError(refusal_of(path, errno));
    return file;
}

/// Whether a file, or a folder with its entries, is on the disk; otherwise errno says why not.
bool flushed(const std::filesystem::path& path) {
    const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0) return false;
    const bool done = ::fsync(file) == 0;
    const int reason = errno;
    ::close(file);
    errno = reason;
    return done;
}

/// So little that a painting hardly fits.
bool is_almost_full(const std::filesystem::path& folder) {
    constexpr std::uint64_t kLittle_bytes = 8 << 20;
    return core::free_bytes(folder).value_or(kLittle_bytes) < kLittle_bytes;
}

bool is_large(const document::Event& event) {
    const auto* texture = std::get_if<document::LayTexture>(&event.action);
    return std::holds_alternative<document::PaintPicture>(event.action) ||
           std::holds_alternative<document::BringPaint>(event.action) ||
           std::holds_alternative<document::LayTracing>(event.action) ||
           std::holds_alternative<document::LayReference>(event.action) ||
           (texture != nullptr && std::holds_alternative<layers::PressedTexture>(texture->texture));
}

/// Where the frame ends that begins with this event. A picture has a frame of its own, and paint of
/// another painting.
std::size_t end_of_batch(const std::vector<document::Event>& events, std::size_t begin) {
    if (begin < events.size() && is_large(events[begin])) return begin + 1;
    std::size_t end = begin;
    while (end < events.size() && end < begin + kMostBatchEvents && !is_large(events[end]))
        ++end;
    return end;
}

double seconds_since(std::chrono::steady_clock::time_point when) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - when).count();
}

}  // namespace

JournalWriter::JournalWriter(const std::filesystem::path& root, const Beginning& beginning, Pace pace,
                             Told told)
    : pace_(pace),
      told_(std::move(told)),
      claim_(Claim::on_new_folder(root)),
      canvas_(beginning.canvas),
      starts_bare_image_(!beginning.write_start && beginning.canvas.support == "image"),
      checkpoint_at_(Clock::now()),
      tick_(beginning.tick),
      written_tick_(beginning.tick),
      checkpoints_(claim_.folder(), [this](const Checkpoint& checkpoint, const core::Message& error) {
          {
              const std::lock_guard lock(mutex_);
              if (error.empty()) pending_frames_.push_back(checkpoint_frame(checkpoint));
              checkpoint_failed_ = !error.empty();
              note_trouble(
                  checkpoint_trouble_,
                  {.reason = error, .disk_is_full = is_almost_full(folder()), .strokes_are_kept = true});
          }
          wake_.notify_all();
      }) {
    try {
        if (beginning.write_start) beginning.write_start(folder() / kStartFile);
        file_ = opened(folder() / kStrokesFile);
        const document::Recording nothing{canvas_, {}, beginning.tick};
        if (!append(header_frame(header_of(beginning)) + strokes_frame(0, beginning.tick, nothing)))
            throw core::InputError(refusal_of(folder() / kStrokesFile, errno));
        thread_ = core::Thread([this] { run(); },
                               [this](const core::Message& sentence) {
                                   const std::lock_guard lock(mutex_);
                                   note_trouble(strokes_trouble_, {.reason = sentence});
                               });
    } catch (...) {
        if (file_ >= 0) ::close(file_);
        claim_.discard();
        throw;
    }
}

JournalWriter::~JournalWriter() {
    checkpoints_.wait();
    {
        const std::lock_guard lock(mutex_);
        stopping_ = true;
    }
    wake_.notify_all();
    thread_.join();
    if (::close(file_) != 0 && !discarded_)
        note_trouble(strokes_trouble_, {.reason = refusal_of(folder() / kStrokesFile, errno)});
    if (discarded_) claim_.discard();
}

void JournalWriter::note(const document::Event& event) {
    ++events_;
    since_checkpoint_.note(event.action);
    painted_since_ = painted_since_ || document::traits_of(event.action).changes_painting;
    {
        const std::lock_guard lock(mutex_);
        pending_.push_back(event);
        tick_ = event.tick;
    }
    wake_.notify_all();
}

void JournalWriter::note_tick(std::int64_t tick, bool paint_moves) {
    bool wakes = false;
    {
        const std::lock_guard lock(mutex_);
        tick_ = tick;
        paint_moves_ = paint_moves;
        wakes = time_is_due();
    }
    if (wakes) wake_.notify_all();
}

/// The lock is held.
bool JournalWriter::time_is_due() const {
    return tick_ - written_tick_ >= (paint_moves_ ? kQuietTicks : kRestTicks);
}

bool JournalWriter::wants_checkpoint(double work_s) const {
    if (checkpoints_.busy()) return false;
    if (since_checkpoint_.crossed() || starts_bare_image_) return true;
    const double since_s = seconds_since(checkpoint_at_);
    if (checkpoint_failed_ && since_s >= pace_.rests * pace_.retry_s) return true;
    if (since_s < pace_.rests * checkpoints_.last_took_s()) return false;
    return work_s - work_at_checkpoint_s_ >= pace_.replay_s ||
           (painted_since_ && since_s >= pace_.idle_s);
}

void JournalWriter::write_checkpoint(document::PaintingState state, double work_s) {
    since_checkpoint_ = {};
    starts_bare_image_ = painted_since_ = false;
    work_at_checkpoint_s_ = work_s;
    checkpoint_at_ = Clock::now();
    checkpoints_.write(std::move(state), events_);
}

void JournalWriter::note_saved(const std::filesystem::path& path, std::uint64_t events) {
    {
        const std::lock_guard lock(mutex_);
        pending_frames_.push_back(saved_frame({path.string(), events}));
    }
    wake_.notify_all();
}

void JournalWriter::discard() {
    const std::lock_guard lock(mutex_);
    discarded_ = true;
}

void JournalWriter::run() {
    flush_start();
    std::unique_lock lock(mutex_);
    while (!stopping_) {
        write_pending(lock);
        wait_for_more(lock);
        const double pause_s = strokes_trouble_.reason.empty() ? pace_.flush_s : pace_.retry_s;
        wake_.wait_for(lock, std::chrono::duration<double>(pause_s), [this] { return stopping_; });
    }
    write_pending(lock);
}

/// Until something is to be written.
void JournalWriter::wait_for_more(std::unique_lock<std::mutex>& lock) {
    wake_.wait(lock, [this] {
        return stopping_ || !pending_.empty() || !pending_frames_.empty() || time_is_due();
    });
}

/// What the start was copied from may not outlive it. Where a folder cannot be flushed (some network
/// drives), its files stand there nevertheless.
void JournalWriter::flush_start() {
    flushed(folder());
    flushed(folder().parent_path());
    const std::filesystem::path start = folder() / kStartFile;
    if (!core::is_there(start) || flushed(start)) return;
    const int reason = errno;
    const std::lock_guard lock(mutex_);
    note_trouble(checkpoint_trouble_,
                 {.reason = refusal_of(start, reason), .disk_is_full = core::says_full(reason)});
}

/// What could not be written is tried again with the next batch.
void JournalWriter::write_pending(std::unique_lock<std::mutex>& lock) {
    const bool time_alone = pending_.empty() && pending_frames_.empty();
    const bool worth_it = !time_alone || time_is_due() || (stopping_ && tick_ > written_tick_);
    if (discarded_ || !worth_it) return;
    std::vector<document::Event> events = std::exchange(pending_, {});
    std::vector<std::string> frames = std::exchange(pending_frames_, {});
    const std::int64_t tick = tick_;
    lock.unlock();
    const Trouble trouble = write(events, tick, frames);
    lock.lock();
    note_trouble(strokes_trouble_, trouble);
    if (trouble.reason.empty()) {
        written_events_ += events.size();
        written_tick_ = tick;
        return;
    }
    pending_.insert(pending_.begin(), std::make_move_iterator(events.begin()),
                    std::make_move_iterator(events.end()));
    pending_frames_.insert(pending_frames_.begin(), frames.begin(), frames.end());
}

/// Without a reason where it is written.
Trouble JournalWriter::write(const std::vector<document::Event>& events, std::int64_t tick,
                             const std::vector<std::string>& frames) {
    Trouble trouble;
    trouble.reason = core::fault_of([&] {
        const std::string bytes = pending_frames({canvas_, events, tick}, written_events_, frames);
        trouble.waiting_bytes = bytes.size();
        if (append(bytes)) return;
        trouble.disk_is_full = core::says_full(errno);
        throw core::InputError(refusal_of(folder() / kStrokesFile, errno));
    });
    return trouble;
}

std::string JournalWriter::pending_frames(document::Recording batch, std::uint64_t first_event,
                                          const std::vector<std::string>& frames) const {
    std::string bytes;
    const std::vector<document::Event> events = std::exchange(batch.events, {});
    std::size_t begin = 0;
    do {
        const std::size_t end = end_of_batch(events, begin);
        document::Recording part{canvas_,
                                 {events.begin() + static_cast<std::ptrdiff_t>(begin),
                                  events.begin() + static_cast<std::ptrdiff_t>(end)},
                                 end == events.size() ? batch.end_tick : events[end - 1].tick};
        const std::int64_t first_tick = part.events.empty() ? part.end_tick : part.events.front().tick;
        bytes += strokes_frame(first_event + begin, first_tick, part);
        begin = end;
    } while (begin < events.size());
    for (const std::string& frame : frames)
        bytes += frame;
    return bytes;
}

/// Nothing half-written stays: what could not be flushed is not taken for written either. Otherwise
/// errno says why it is not written.
bool JournalWriter::append(const std::string& bytes) {
    if (torn_ && ::ftruncate(file_, end_) != 0) return false;
    torn_ = !core::write_all(file_, std::as_bytes(std::span(bytes)), static_cast<std::uint64_t>(end_)) ||
            ::fdatasync(file_) != 0;
    if (!torn_) {
        end_ += static_cast<std::int64_t>(bytes.size());
        return true;
    }
    const int reason = errno;
    torn_ = ::ftruncate(file_, end_) != 0;
    errno = reason;
    return false;
}

/// Locked. Strokes that are not kept are told before a checkpoint that is not.
void JournalWriter::note_trouble(Trouble& of, Trouble now) {
    const bool changes = of.reason != now.reason;
    of = std::move(now);
    if (changes && told_)
        told_(strokes_trouble_.reason.empty() ? checkpoint_trouble_ : strokes_trouble_);
}

}  // namespace pastoso::journal
