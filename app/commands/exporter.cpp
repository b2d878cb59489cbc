#include "commands/exporter.hpp"

#include "core/check.hpp"
#include "core/thread_pool.hpp"

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

files::ExportStatus ExportOutcome::status() const {
    return std::visit([](const auto& known) { return known.status; }, report);
}

Exporter::Exporter(QObject* parent)
    : QObject(parent),
      worker_([this](ExportJob& job) { end(written(job)); },
              [this](ExportJob& job, const core::Message& fault) {
                  end({.path = path_of(job), .error = fault});
              },
              kNice) {
    progress_.setInterval(kLook_ms);
    connect(&progress_, &QTimer::timeout, this, [this] { Q_EMIT progressed(done_); });
}

void Exporter::start(ExportJob job) {
    PASTOSO_CHECK(!busy_);
    path_ = path_of(job);
    busy_ = true;
    stopped_ = false;
    done_ = 0.0;
    progress_.start();
    worker_.add(std::move(job));
}

ExportOutcome Exporter::written(ExportJob& job) {
    ExportOutcome outcome{.path = path_of(job)};
    const auto keep_going = [this](double done) {
        done_ = done;
        return !stopped_;
    };
    core::ThreadPool pool;
    if (const auto* choice = std::get_if<recordings::ExportChoice>(&job.choice))
        outcome.report = recordings::export_painting(job.painting, *choice, pool, keep_going);
    else if (const auto* copy = std::get_if<project::LayeredCopy>(&job.choice))
        outcome.report = project::save_layered_copy(*copy, job.painting, pool, keep_going);
    else
        outcome.report = recordings::export_timelapse(job.record.value().recording(),
                                                      std::get<recordings::TimelapseChoice>(job.choice),
                                                      pool, keep_going);
    return outcome;
}

/// Told on the object's thread.
void Exporter::end(ExportOutcome outcome) {
    QMetaObject::invokeMethod(
        this,
        [this, outcome = std::move(outcome)] {
            busy_ = false;
            progress_.stop();
            Q_EMIT progressed(done_);
            Q_EMIT finished(outcome);
        },
        Qt::QueuedConnection);
}

}  // namespace pastoso::commands
