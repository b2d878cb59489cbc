// Every moment of a tank as a numbered file in a folder while the liquid moves: pictures of what is
// seen, surfaces, or both.
#pragma once

#include "core/worker.hpp"
#include "session/tank_session.hpp"

#include <array>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

#include <QObject>
#include <QString>

namespace pastoso::glass {
class TankView;
}

namespace pastoso::main {

/// liquid_0001.png as the view shows the tank at rest, or liquid_0001.obj.
enum class Recorded { Pictures, Surfaces };
inline constexpr Recorded kRecorded[] = {Recorded::Pictures, Recorded::Surfaces};

/// The liquid waits at every moment until that is taken, so that none is missed; a file is written while
/// the next moment is computed. Pictures are made while the view is seen.
class TankRecorder : public QObject {
    Q_OBJECT
  public:
    TankRecorder(session::TankSession& session, glass::TankView& view);

    /// Begins with the moment at which the liquid stands. Files that are in the folder stay: numbers go
    /// on after theirs.
    void start(Recorded what, const QString& folder);
    /// The file that is being written is completed.
    void stop(Recorded what);

    bool records(Recorded what) const { return series(what).has_value(); }
    /// Files written so far.
    int written(Recorded what) const { return records(what) ? series(what)->written : 0; }

    /// To be told of every moment that is published.
    void look(std::shared_ptr<const session::TankSnapshot> snapshot);

  Q_SIGNALS:
    void progressed();
    /// By stop(), or because a file could not be written; a sentence.
    void ended(pastoso::main::Recorded what, const QString& told);

  private:
    using Write = std::function<void(const std::filesystem::path&)>;

    struct Series {
        QString folder, ending;
        int next = 1, written = 0;
        bool writing = false, stopping = false;
        std::shared_ptr<const session::TankSnapshot> taken;  ///< the latest one
    };

    struct Order {
        Recorded what;
        Write write;
        std::filesystem::path file;
    };

    const std::optional<Series>& series(Recorded what) const {
        return series_[static_cast<std::size_t>(what)];
    }
    std::optional<Series>& series(Recorded what) { return series_[static_cast<std::size_t>(what)]; }
    void proceed();
    bool take(Recorded what);
    Write writer(Recorded what);
    void tell_done(Recorded what, const core::Message& error);
    void file_done(Recorded what, const QString& error);
    void end(Recorded what, const QString& told);

    session::TankSession& session_;
    glass::TankView& view_;
    std::array<std::optional<Series>, 2> series_;
    std::shared_ptr<const session::TankSnapshot> snapshot_;  ///< the latest one
    core::Worker<Order> worker_;
};

}  // namespace pastoso::main
