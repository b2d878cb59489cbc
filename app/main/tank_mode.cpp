#include "main/tank_mode.hpp"

#include "core/error.hpp"
#include "io/mesh_export.hpp"
#include "io/tank_json.hpp"
#include "main/queued_refresh.hpp"
#include "tea/glass_chooser.hpp"
#include "tea/tank_page.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QAction>
#include <QCoreApplication>
#include <QFileDialog>
#include <QMainWindow>
#include <QMessageBox>
#include <glm/common.hpp>

namespace pastoso::main {
namespace {

using commands::Command;

constexpr double kTurn_deg = 15.0, kStronger_m_s = 0.5;
constexpr const char* kFalling = "falling-liquid";
constexpr const char* kTwoLiquids = "two-liquids";

constexpr std::pair<Command, const char*> kButtonWords[] = {
    {Command::TankRestart, QT_TR_NOOP("Start again")},
    {Command::TankOpenScene, QT_TR_NOOP("Open")},
    {Command::TankBall, QT_TR_NOOP("Ball")},
    {Command::TankDrain, QT_TR_NOOP("Drain")},
    {Command::TankWind, QT_TR_NOOP("Wind")},
    {Command::TankVelocity, QT_TR_NOOP("Velocities")},
    {Command::TankExportAll, QT_TR_NOOP("Export all moments...")},
};

io::ExportStatus write_surface(const session::TankPlace& place, const session::TankSeen& seen,
                               const std::filesystem::path& file, core::ThreadPool& pool,
                               const std::atomic<bool>& stops) {
    io::MeshExportOptions options;
    options.what = "liquid";
    return io::export_mesh(file, session::liquid_surface(place, seen, 0.0F, pool), options,
                           [&stops](double) { return !stops; });
}

}  // namespace

TankMode::TankMode(Studio& studio, CanvasPlace& place)
    : studio_(studio), place_(place), export_(studio) {
    connect_commands();
    connect_wind();
}

TankMode::~TankMode() = default;

void TankMode::connect_commands() {
    commands::CommandRegistry& commands = studio_.commands();
    for (const auto& [command, words] : kButtonWords)
        commands.action(command)->setIconText(QCoreApplication::translate("pastoso::main", words));
    const auto here = [&](Command command, std::function<void(bool)> what) {
        commands.on(command, [this, what = std::move(what)](bool on) {
            if (active_) what(on);
        });
    };
    commands.on(Command::GlassTank, [this](bool tank) { tank ? enter() : leave(); });
    here(Command::TankFalling, [this](bool) { choose(QString::fromLatin1(kFalling)); });
    here(Command::TankTwoLiquids, [this](bool) { choose(QString::fromLatin1(kTwoLiquids)); });
    here(Command::TankOpenScene, [this](bool) { ask_open(); });
    here(Command::TankRestart, [this](bool) { session_->new_tank(scene_); });
    here(Command::TankBall, [this](bool) { drop_ball(0.5F * glm::vec2(scene_.size_m())); });
    here(Command::TankDrain, [this](bool open) { session_->open_drains(open); });
    here(Command::TankVelocity, [this](bool shown) { page_->view().show_velocity(shown); });
    here(Command::TankExportAll, [this](bool) { ask_export_all(); });
    here(Command::TeaExportMesh, [this](bool) { ask_export(); });
    here(Command::TeaPause, [this](bool paused) { session_->set_paused(paused); });
    here(Command::TeaFullSpeed, [this](bool full) { session_->set_full_speed(full); });
    here(Command::TeaFrontView, [this](bool) { page_->view().look_from_front(); });
}

void TankMode::connect_wind() {
    const commands::CommandRegistry& commands = studio_.commands();
    for (const Command arrow : {Command::TankWindLeft, Command::TankWindRight, Command::TankWindStronger,
                                Command::TankWindWeaker})
        commands.action(arrow)->setShortcutContext(Qt::WidgetShortcut);
    commands.on(Command::TankWind, [this](bool on) {
        session::TankWind wind = wind_;
        wind.on = on;
        use_wind(wind);
    });
    commands.on(Command::TankWindLeft, [this](bool) { turn_wind(kTurn_deg); });
    commands.on(Command::TankWindRight, [this](bool) { turn_wind(-kTurn_deg); });
    commands.on(Command::TankWindStronger, [this](bool) { blow_harder(kStronger_m_s); });
    commands.on(Command::TankWindWeaker, [this](bool) { blow_harder(-kStronger_m_s); });
}

void TankMode::make_page() {
    const auto action = [&](Command command) { return studio_.commands().action(command); };
    page_ = new tea::TankPage({.back = action(Command::GlassTank),
                               .restart = action(Command::TankRestart),
                               .open = action(Command::TankOpenScene),
                               .ball = action(Command::TankBall),
                               .drain = action(Command::TankDrain),
                               .wind = action(Command::TankWind),
                               .left = action(Command::TankWindLeft),
                               .right = action(Command::TankWindRight),
                               .stronger = action(Command::TankWindStronger),
                               .weaker = action(Command::TankWindWeaker),
                               .velocity = action(Command::TankVelocity),
                               .export_mesh = action(Command::TeaExportMesh),
                               .export_all = action(Command::TankExportAll),
                               .pause = action(Command::TeaPause),
                               .full_speed = action(Command::TeaFullSpeed),
                               .front = action(Command::TeaFrontView)});
    place_.add(page_);
    // Elsewhere the arrows go from value to value.
    for (const Command arrow : {Command::TankWindLeft, Command::TankWindRight, Command::TankWindStronger,
                                Command::TankWindWeaker})
        page_->view().addAction(action(arrow));
    tea::TankPanel& panel = page_->panel();
    connect(&panel.chooser(), &tea::GlassChooser::chosen, this, &TankMode::choose);
    connect(&panel, &tea::TankPanel::wind_changed, this, &TankMode::use_wind);
    connect(&panel, &tea::TankPanel::numbers_changed, this, [this](const tank::TankScene& numbers) {
        for (const tank::TankNumber& number : tank::tank_numbers())
            scene_.*number.value = numbers.*number.value;
        session_->set_numbers(numbers);
    });
    connect(&panel, &tea::TankPanel::ball_changed, this,
            [this](const tea::TankBall& ball) { page_->view().set_ball_radius(ball.radius_m); });
    connect(&page_->view(), &tea::TankView::ball_wanted, this, &TankMode::drop_ball);
    connect(&page_->view(), &tea::TankView::failed, &studio_, &Studio::report);
    connect(page_, &tea::TankPage::step_wanted, this, [this](int step) { session_->show(step); });
}

// ---- coming and going

void TankMode::enter() {
    if (active_) return;
    if (page_ == nullptr) make_page();
    if (session_ == nullptr && key_.isEmpty()) {
        key_ = QString::fromLatin1(kFalling);
        scene_ = io::read_tank(kFalling);
    }
    place_.take(page_, commands::Mode::Tank, [this] { put_away(); });
    active_ = true;
    studio_.commands().action(Command::GlassTank)->setChecked(true);
    studio_.commands().action(Command::TeaPause)->setChecked(paused_);
    page_->panel().chooser().show_choice(key_);
    if (session_ == nullptr)
        session_ = std::make_unique<session::TankSession>(
            scene_, paused_, queued_refresh(this, [this] { show_published(); }));
    else
        session_->set_paused(paused_);
    page_->view().setFocus();
}

void TankMode::leave() {
    if (active_) place_.give_back();
}

/// The hand finds the pause as it left it; only time stands still while nobody looks.
void TankMode::put_away() {
    active_ = false;
    paused_ = studio_.commands().action(Command::TeaPause)->isChecked();
    session_->set_paused(true);
    studio_.commands().action(Command::GlassTank)->setChecked(false);
}

void TankMode::choose(const QString& key) {
    if (key == tea::GlassChooser::tea_key()) {
        Q_EMIT tea_wanted();
        return;
    }
    if (key.isEmpty()) return ask_open();
    try {
        open_scene(key);
    } catch (const core::InputError& error) {
        if (page_ != nullptr) page_->panel().chooser().show_choice(key_);
        QMessageBox::warning(&studio_.window(), tr("Open a tank"), QString::fromUtf8(error.what()));
    }
}

void TankMode::open_scene(const QString& path_or_name) {
    scene_ = io::read_tank(path_or_name.toStdString());
    key_ = path_or_name;
    if (session_ != nullptr) session_->new_tank(scene_);
    enter();
    page_->panel().chooser().show_choice(key_);
    page_->view().setFocus();
}

void TankMode::ask_open() {
    const QString path = QFileDialog::getOpenFileName(&studio_.window(), tr("Open a tank"), {},
                                                      tr("Scenes of a tank (*.json);;All files (*)"));
    if (!path.isEmpty()) choose(path);
}

// ---- what is published

void TankMode::show_published() {
    const session::TankStatus status = session_->status();
    bool refused = false;
    for (const std::string& error : session_->take_errors()) {
        studio_.report_refusal(QString::fromStdString(error));
        refused = true;
    }
    if (const auto moment = session_->moment()) {
        page_->view().show_moment(moment);
        // What was refused is not to be read as if it held.
        if (refused || status.glass != shown_glass_) show_tank(status);
    }
    page_->show_status(status);
    if (!active_) return;
    // Scrubbing pauses.
    studio_.commands().action(Command::TeaPause)->setChecked(status.paused);
    studio_.commands().action(Command::TeaFullSpeed)->setChecked(status.full_speed);
}

void TankMode::show_tank(const session::TankStatus& status) {
    shown_glass_ = status.glass;
    page_->panel().show_scene(scene_);
    page_->view().set_ball_radius(page_->panel().ball().radius_m);
    wind_ = status.wind;
    page_->panel().show_wind(wind_);
    page_->view().show_wind(wind_);
    studio_.commands().action(Command::TankWind)->setChecked(wind_.on);
    studio_.commands().action(Command::TankDrain)->setChecked(status.drains_open);
}

// ---- what is done to the liquid

void TankMode::drop_ball(const glm::vec2& at_m) {
    const tea::TankBall& ball = page_->panel().ball();
    const glm::vec3 size_m = scene_.size_m();
    const glm::vec3 margin_m = glm::min(glm::vec3(1.02F * ball.radius_m), 0.5F * size_m);
    const glm::vec3 centre_m = glm::clamp(glm::vec3(at_m, size_m.z), margin_m, size_m - margin_m);
    session_->add_sphere({centre_m, ball.radius_m}, ball.milk);
}

void TankMode::use_wind(const session::TankWind& wind) {
    wind_ = wind;
    session_->set_wind(wind);
    page_->panel().show_wind(wind);
    page_->view().show_wind(wind);
    studio_.commands().action(Command::TankWind)->setChecked(wind.on);
}

void TankMode::turn_wind(double by_deg) {
    session::TankWind wind = wind_;
    wind.direction_deg = std::remainder(wind.direction_deg + by_deg, 360.0);
    use_wind(wind);
}

void TankMode::blow_harder(double by_m_s) {
    session::TankWind wind = wind_;
    wind.speed_m_s = std::clamp(wind.speed_m_s + by_m_s, 0.0, tank::kMostSpeed_m_s);
    use_wind(wind);
}

// ---- surfaces

void TankMode::ask_export() {
    const QString path = QFileDialog::getSaveFileName(
        &studio_.window(), tr("Export the liquid's surface"), QStringLiteral("liquid_0001.obj"),
        tr("Surfaces (*.pbrt *.obj *.ply *.stl)"));
    if (path.isEmpty()) return;
    try {
        export_mesh(path);
    } catch (const core::InputError& error) {
        QMessageBox::warning(&studio_.window(), tr("Export the liquid's surface"),
                             QString::fromUtf8(error.what()));
    }
}

void TankMode::ask_export_all() {
    const QString folder =
        QFileDialog::getExistingDirectory(&studio_.window(), tr("A folder for all moments"));
    if (!folder.isEmpty()) export_all(folder);
}

void TankMode::export_mesh(const QString& path) {
    const std::filesystem::path file = path.toStdString();
    if (!io::is_mesh_path(file))
        throw core::InputError(file.string() +
                               ": the name must end in .pbrt, .obj, .ply or .stl. Choose one of them.");
    const auto moment = session_->moment();
    if (moment == nullptr) return;
    export_.start([moment, file, told = tr("The liquid's surface is in %1.").arg(path)](
                      const std::atomic<bool>& stops) {
        core::ThreadPool pool;
        const auto status = write_surface(*moment->place, moment->seen, file, pool, stops);
        return status == io::ExportStatus::Stopped ? QString() : told;
    });
}

void TankMode::export_all(const QString& folder) {
    const session::TankSession::Kept kept = session_->kept();
    if (kept.place == nullptr) return;
    const std::vector<int> steps = kept.frames.steps();
    const QString told = tr("All surfaces are in %1.").arg(folder);
    export_.start([kept, steps, told, folder](const std::atomic<bool>& stops) {
        core::ThreadPool pool;
        int number = 0;
        for (const int step : steps) {
            const QString name = QStringLiteral("/liquid_%1.obj").arg(++number, 4, 10, QLatin1Char('0'));
            const std::filesystem::path file = (folder + name).toStdString();
            if (write_surface(*kept.place, kept.frames.at(step), file, pool, stops) ==
                io::ExportStatus::Stopped)
                return QString();
        }
        return told;
    });
}

}  // namespace pastoso::main
