#include "journal/journal_writer.hpp"

#include "core/error.hpp"
#include "journal/frames.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <iterator>
#include <unistd.h>
#include <utility>

namespace pastoso::journal {
namespace {

constexpr const char* kStartFile = "start.pastoso";

/// A batch of more is written in several frames: a frame stays small enough to be read.
constexpr std::size_t kMostBatchEvents = 4096;

/// Time that passes without actions is written four times a second.
constexpr std::int64_t kQuietTicks = 15;

Header header_of(const Beginning& beginning) {
    return {.program = PASTOSO_VERSION,
            .painting = beginning.painting.string(),
            .start = beginning.write_start ? kStartFile : "",
            .start_tick = beginning.tick,
            .start_is_saved = beginning.is_saved};
}

int opened(const std::filesystem::path& path) {
    const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
    if (file < 0)
        throw core::InputError(path.string() + ": cannot be written (" + std::strerror(errno) + ").");
    return file;
}

bool write_all(int file, const std::string& bytes) {
    for (std::size_t done = 0; done < bytes.size();) {
        const ssize_t written = ::write(file, bytes.data() + done, bytes.size() - done);
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return false;
        done += static_cast<std::size_t>(written);
    }
    return true;
}

bool is_picture(const document::Event& event) {
    return std::holds_alternative<document::PaintPicture>(event.action) ||
           std::holds_alternative<document::LayTracing>(event.action);
}

/// Where the frame ends that begins with this event. A picture has a frame of its own.
std::size_t end_of_batch(const std::vector<document::Event>& events, std::size_t begin) {
    if (begin < events.size() && is_picture(events[begin])) return begin + 1;
    std::size_t end = begin;
    while (end < events.size() && end < begin + kMostBatchEvents && !is_picture(events[end]))
        ++end;
    return end;
}

double seconds_since(std::chrono::steady_clock::time_point when) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - when).count();
}

}  // namespace

JournalWriter::JournalWriter(const std::filesystem::path& root, const Beginning& beginning, Pace pace)
    : pace_(pace),
      claim_(Claim::on_new_folder(root)),
      canvas_(beginning.canvas),
      starts_bare_image_(!beginning.write_start && beginning.canvas.support == "image"),
      checkpoint_at_(Clock::now()),
      tick_(beginning.tick),
      written_tick_(beginning.tick),
      checkpoints_(claim_.folder(), [this](const Checkpoint& checkpoint, const std::string& error) {
          const std::lock_guard lock(mutex_);
          if (error.empty())
              pending_frames_.push_back(checkpoint_frame(checkpoint));
          else
              fault(error);
      }) {
    try {
        if (beginning.write_start) beginning.write_start(folder() / kStartFile);
        file_ = opened(folder() / kStrokesFile);
        const document::Recording nothing{canvas_, {}, beginning.tick};
        if (!append(header_frame(header_of(beginning)) + strokes_frame(0, beginning.tick, nothing)))
            throw core::InputError(folder().string() + ": the journal cannot be written.");
    } catch (...) {
        if (file_ >= 0) ::close(file_);
        claim_.discard();
        throw;
    }
    thread_ = core::Thread([this] { run(); },
                           [this](const std::string& sentence) {
                               const std::lock_guard lock(mutex_);
                               fault(sentence);
                           });
}

JournalWriter::~JournalWriter() {
    checkpoints_.wait();
    {
        const std::lock_guard lock(mutex_);
        stopping_ = true;
    }
    wake_.notify_all();
    thread_.join();
    ::close(file_);
    if (discarded_) claim_.discard();
}

void JournalWriter::note(const document::Event& event) {
    ++events_;
    since_checkpoint_.note(event.action);
    painted_since_ = painted_since_ || document::traits_of(event.action).changes_painting;
    const std::lock_guard lock(mutex_);
    pending_.push_back(event);
    tick_ = event.tick;
}

void JournalWriter::note_tick(std::int64_t tick) {
    const std::lock_guard lock(mutex_);
    tick_ = tick;
}

bool JournalWriter::wants_checkpoint(double work_s) const {
    if (checkpoints_.busy()) return false;
    if (since_checkpoint_.crossed() || starts_bare_image_) return true;
    const double since_s = seconds_since(checkpoint_at_);
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
    const std::lock_guard lock(mutex_);
    pending_frames_.push_back(saved_frame({path.string(), events}));
}

void JournalWriter::discard() {
    const std::lock_guard lock(mutex_);
    discarded_ = true;
}

std::vector<std::string> JournalWriter::take_faults() {
    const std::lock_guard lock(mutex_);
    return std::exchange(faults_, {});
}

void JournalWriter::run() {
    std::unique_lock lock(mutex_);
    while (!stopping_) {
        write_pending(lock);
        wake_.wait_for(lock, std::chrono::duration<double>(pace_.flush_s), [this] { return stopping_; });
    }
    write_pending(lock);
}

/// What could not be written is tried again with the next batch.
void JournalWriter::write_pending(std::unique_lock<std::mutex>& lock) {
    const bool time_alone = pending_.empty() && pending_frames_.empty();
    const std::int64_t least_ticks = stopping_ ? 1 : kQuietTicks;
    if (discarded_ || (time_alone && tick_ - written_tick_ < least_ticks)) return;
    std::vector<document::Event> events = std::exchange(pending_, {});
    std::vector<std::string> frames = std::exchange(pending_frames_, {});
    const std::int64_t tick = tick_;
    lock.unlock();
    std::string refusal;
    const bool written = write(events, tick, frames, refusal);
    lock.lock();
    if (written) {
        written_events_ += events.size();
        written_tick_ = tick;
        failing_ = false;
        return;
    }
    pending_.insert(pending_.begin(), std::make_move_iterator(events.begin()),
                    std::make_move_iterator(events.end()));
    pending_frames_.insert(pending_frames_.begin(), frames.begin(), frames.end());
    if (!std::exchange(failing_, true)) fault(refusal);
}

/// Otherwise says why it is not written.
bool JournalWriter::write(const std::vector<document::Event>& events, std::int64_t tick,
                          const std::vector<std::string>& frames, std::string& refusal) {
    bool written = false;
    refusal = core::fault_of([&] {
        written = append(pending_frames({canvas_, events, tick}, written_events_, frames));
        if (!written)
            throw core::InputError(folder().string() + ": the journal cannot be written (" +
                                   std::strerror(errno) +
                                   "); what is painted now would not be recovered.");
    });
    return written;
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

/// Nothing half-written stays.
bool JournalWriter::append(const std::string& bytes) {
    const off_t end = ::lseek(file_, 0, SEEK_END);
    if (end >= 0 && write_all(file_, bytes) && ::fdatasync(file_) == 0) return true;
    const int reason = errno;
    if (end >= 0 && ::ftruncate(file_, end) == 0) ::lseek(file_, end, SEEK_SET);
    errno = reason;
    return false;
}

void JournalWriter::fault(const std::string& sentence) {
    faults_.push_back(sentence);
}

}  // namespace pastoso::journal
