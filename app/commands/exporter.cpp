#include "commands/exporter.hpp"

#include "core/background_thread.hpp"
#include "core/check.hpp"
#include "core/thread_pool.hpp"

#include <exception>
#include <utility>

namespace pastoso::commands {
namespace {

/// A tenth of a processor beside a thread that wants all of it, and whatever nobody wants.
constexpr int kNice = 10;

constexpr int kLook_ms = 100;

}  // namespace

std::filesystem::path path_of(const ExportJob& job) {
    return std::visit([](const auto& choice) { return choice.path; }, job.choice);
}

io::ExportStatus ExportOutcome::status() const {
    return std::visit([](const auto& known) { return known.status; }, report);
}

Exporter::Exporter(QObject* parent) : QObject(parent) {
    progress_.setInterval(kLook_ms);
    connect(&progress_, &QTimer::timeout, this, [this] { Q_EMIT progressed(done_); });
}

Exporter::~Exporter() {
    stop();
    if (thread_.joinable()) thread_.join();
}

void Exporter::start(ExportJob job) {
    PASTOSO_CHECK(!busy());
    path_ = path_of(job);
    stopped_ = false;
    done_ = 0.0;
    progress_.start();
    thread_ = std::thread([this, job = std::move(job)]() mutable { run(std::move(job)); });
}

void Exporter::run(ExportJob job) {
    core::lower_priority(kNice);
    ExportOutcome outcome{.path = path_of(job)};
    const auto keep_going = [this](double done) {
        done_ = done;
        return !stopped_;
    };
    try {
        core::ThreadPool pool;
        if (const auto* choice = std::get_if<io::ExportChoice>(&job.choice))
            outcome.report = io::export_painting(job.painting, *choice, pool, keep_going);
        else
            outcome.report = io::export_timelapse(
                std::move(job.recording), std::get<io::TimelapseChoice>(job.choice), pool, keep_going);
    } catch (const std::exception& failure) {
        outcome.error = failure.what();
    }
    QMetaObject::invokeMethod(
        this, [this, outcome = std::move(outcome)] { end(outcome); }, Qt::QueuedConnection);
}

void Exporter::end(const ExportOutcome& outcome) {
    thread_.join();
    progress_.stop();
    Q_EMIT finished(outcome);
}

}  // namespace pastoso::commands
