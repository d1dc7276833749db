#include "ui/features/session_feature.h"

#include <QFileInfo>
#include <QStandardPaths>
#include <QThread>
#include <QUuid>
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <system_error>
#include <tuple>
#include <utility>

#include "core/base/log.h"
#include "ui/file_choice.h"
#include "ui/preferences.h"
#include "ui/tool_bar.h"

namespace lacuna::ui {

namespace {

constexpr int k_tick_ms = 5000;
constexpr qint64 k_rest_ms = 5000;  ///< without a change: what was done until then is kept at once

/// Those of the windows there are. Never destroyed: it is asked while the program ends.
std::vector<SessionFeature*>& living() {
    static auto* const features = new std::vector<SessionFeature*>;
    return *features;
}

/// Runs as the program exits. Windows that are still there then were not closed: something called exit() under them.
void keep_what_lives() {
    if (living().empty()) return;
    for (SessionFeature* feature : living())
        if (feature->thread() == QThread::currentThread()) feature->keepNow();
    std::_Exit(EXIT_FAILURE);  // jobs still run, and would go on with what the end of the program takes away
}

QString session_filter() { return SessionFeature::tr("Sessions (*.lacuna)"); }

bool same(const OpenOptions& a, const OpenOptions& b) {
    return std::tie(a.raw, a.series, a.keep_gaps, a.spacing_mm) == std::tie(b.raw, b.series, b.keep_gaps, b.spacing_mm);
}

/// In one step: another window may do the same.
void make_last(const QString& file) {
    std::error_code ignored;
    std::filesystem::rename(file.toStdString(), SessionFeature::lastFile().toStdString(), ignored);
}

bool data_exists(const Session& session) {
    return session.input.starts_with("sample:") || QFileInfo::exists(QString::fromStdString(session.input));
}

}  // namespace

QDir SessionFeature::autosaveFolder() {
    const QDir folder(QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) +
                      QStringLiteral("/sessions"));
    folder.mkpath(QStringLiteral("."));
    // A path of data may name a patient: nobody else's eyes.
    QFile::setPermissions(folder.path(), QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
    return folder;
}

QString SessionFeature::lastFile() { return autosaveFolder().filePath(QStringLiteral("last.lacuna")); }

SessionFeature::SessionFeature(Workbench& bench, InspectionFeature& inspection, RegionsFeature& regions)
    : QObject(&bench),
      bench_(bench),
      inspection_(inspection),
      regions_(regions),
      read_(this),
      hash_(this),
      write_(std::in_place, this),
      save_(std::in_place, this, bench.tasks(), AtStake::nothing) {  // the window's end writes what is left
    buildMenu();
    const QString name = QStringLiteral("autosave-") + QUuid::createUuid().toString(QUuid::WithoutBraces);
    autosave_file_ = autosaveFolder().filePath(name + QLatin1String(k_session_suffix));
    lock_ = std::make_unique<QLockFile>(autosaveFolder().filePath(name + QStringLiteral(".lock")));
    lock_->setStaleLockTime(0);  // only the death of its process makes it stale
    lock_->tryLock(0);
    connect(&autosave_timer_, &QTimer::timeout, this, [this] {
        const int minutes = preferences::autosave_minutes();  // may be changed at any time
        const bool writing = write_ && write_->running();
        if (minutes > 0 && !writing &&
            (since_autosave_.elapsed() >= qint64(minutes) * 60000 || since_change_.elapsed() >= k_rest_ms))
            autosave();
    });
    autosave_timer_.start(k_tick_ms);
    since_autosave_.start();
    since_change_.start();
    DocumentController* documents = bench.documents();
    connect(documents, &DocumentController::opened, this, &SessionFeature::documentOpened);
    for (const auto signal : {&DocumentController::settingsChanged, &DocumentController::inspectionChanged})
        connect(documents, signal, this, &SessionFeature::changed);
    for (const auto signal : {&DocumentController::cameraChanged, &DocumentController::cursorChanged,
                              &DocumentController::regionsChanged, &DocumentController::selectionChanged})
        connect(documents, signal, this, &SessionFeature::moved);
    connect(bench.loader(), &LoadController::started, this, &SessionFeature::autosave);   // of what is about to go
    connect(bench.loader(), &LoadController::started, this, [this] { read_.cancel(); });  // what came later counts
    connect(inspection.panel(), &InspectionPanel::decided, this, &SessionFeature::changed);
    connect(bench.loader(), &LoadController::failed, this, [this] { pending_.reset(); });
    connect(bench.loader(), &LoadController::cancelled, this, [this] { pending_.reset(); });
    connect(bench.loader(), &LoadController::choiceNeeded, this, [this] { choice_asked_ = true; });
    connect(&bench, &Workbench::stateWanted, this, [this](QVariantMap& state) {
        state[QStringLiteral("session/file")] = file_;
        state[QStringLiteral("session/changed")] = bench_.window()->isWindowModified();
    });
    connect(&bench, &Workbench::stateBack, this, [this](const QVariantMap& state) {
        file_ = state[QStringLiteral("session/file")].toString();
        bench_.window()->setWindowModified(state[QStringLiteral("session/changed")].toBool());
    });
    static const bool keeps = [] { return std::atexit(keep_what_lives) == 0; }();
    if (keeps) living().push_back(this);
    QTimer::singleShot(0, this, &SessionFeature::offerRecovery);
}

SessionFeature::~SessionFeature() { std::erase(living(), this); }

void SessionFeature::keepNow() {
    if (!bench_.documents()->hasDocument()) return;
    try {
        save_session(current(), autosave_file_.toStdString());
    } catch (const Error&) {
        // The one before it is kept.
    }
}

void SessionFeature::finish() {
    write_.reset();  // one that is being written would come after what follows
    save_.reset();
    for (const Saving& left : std::exchange(saving_, {})) {
        try {
            save_session(left.session, left.file.toStdString());
        } catch (const Error&) {  // whose sentence names the file, and that may be a patient's name
            log(LogLevel::error, "The session could not be saved while the window closed.");
        }
    }
    keepNow();
    if (bench_.documents()->hasDocument()) keepAsLast();
}

void SessionFeature::buildMenu() {
    QMenu* file = bench_.menu(Workbench::Menu::file);
    bench_.addAlways(file, tr("Open a sess&ion…"), QKeySequence(QStringLiteral("Ctrl+Alt+O")), this, [this] {
        const QString name =
            file_choice::open_file(bench_.window(), tr("Open a session"), FileKind::session, session_filter());
        if (!name.isEmpty()) openFile(name);
    });
    QAction* last =
        bench_.addAlways(file, tr("Open the &last session again"), {}, this, [this] { openFile(lastFile()); });
    connect(file, &QMenu::aboutToShow, last, [last] { last->setEnabled(QFileInfo::exists(lastFile())); });
    offer_tool(bench_.add(file, tr("Sa&ve the session"), QKeySequence::Save, this, &SessionFeature::save),
               ToolGroup::document, Icon::save, tr("Session"));
    bench_.add(file, tr("Save the session &as…"), QKeySequence(QStringLiteral("Ctrl+Shift+S")), this,
               &SessionFeature::saveAs);
}

/// Worth keeping, but nothing to be asked about.
void SessionFeature::moved() {
    dirty_ = true;
    since_change_.restart();
}

void SessionFeature::changed() {
    moved();
    ++changes_;
    bench_.window()->setWindowModified(true);
}

void SessionFeature::save() {
    if (file_.isEmpty())
        saveAs();
    else
        saveTo(file_);
}

void SessionFeature::saveAs() {
    const QString name = file_choice::save_file(bench_.window(), tr("Save the session"), FileKind::session,
                                                QStringLiteral("session.lacuna"), session_filter());
    if (!name.isEmpty()) saveTo(name);
}

Session SessionFeature::current() const {
    Session session = session_of(bench_.documents()->document(), sha256_);
    if (bench_.documents()->document().inspection) {
        session.criteria = criteria_to_json(inspection_.panel()->form()->criteria());
        // Of the settings before, they are about other defects than these criteria find.
        if (inspection_.panel()->isCurrent()) session.decisions = inspection_.panel()->judgement().by_hand;
    }
    const Document& document = bench_.documents()->document();
    session.regions =
        SessionRegions{regions_.panel()->options(), document.regions != nullptr, document.selected_region};
    return session;
}

void SessionFeature::saveTo(const QString& file) {
    if (!save_ || !bench_.documents()->hasDocument()) return;
    // What waits for the same file is out of date; what is being written there is written before this.
    if (saving_.size() > 1)
        saving_.erase(std::remove_if(saving_.begin() + 1, saving_.end(),
                                     [&](const Saving& waiting) { return waiting.file == file; }),
                      saving_.end());
    saving_.push_back({current(), bench_.documents()->document().volume, file, opened_, changes_});
    if (saving_.size() == 1) saveNext();
}

void SessionFeature::saveNext() {
    if (saving_.empty()) return;
    Saving& next = saving_.front();
    if (next.session.sha256.empty() && next.opened == opened_) next.session.sha256 = sha256_;
    save_->start(
        tr("Saving the session"),
        [session = next.session, volume = next.volume, file = next.file](const JobContext& job) mutable {
            if (session.sha256.empty()) session.sha256 = voxel_sha256(volume, job);
            save_session(session, file.toStdString());
            return file;
        },
        [this, opened = next.opened, changes = next.changes](Outcome<QString> outcome) {
            saving_.pop_front();
            saveNext();
            if (const Error* error = std::get_if<Error>(&outcome)) return bench_.report(*error);
            const QString& written = std::get<0>(outcome);
            // Other data may have been opened since, and things been changed: neither is what was saved.
            if (opened == opened_) {
                file_ = written;
                if (changes == changes_) bench_.window()->setWindowModified(false);
            }
            bench_.messages()->showNotice(tr("The session is saved in %1.").arg(written));
            Q_EMIT saved(written);
        });
}

void SessionFeature::openFile(const QString& file) {
    // A folder on a server that does not answer holds nobody up.
    read_.start(
        [file](const JobContext&) {
            Found found{load_session(file.toStdString())};
            found.data_there = data_exists(found.session);
            return found;
        },
        [this, file](Outcome<Found> outcome) {
            if (const Error* error = std::get_if<Error>(&outcome)) return bench_.report(*error);
            Found& found = std::get<Found>(outcome);
            found.data_there ? start(std::move(found.session), file) : askForData(std::move(found.session), file);
        });
}

void SessionFeature::start(Session session, const QString& file) {
    pending_file_ = file == lastFile() ? QString() : file;  // that one is not the user's
    if (!pending_file_.isEmpty()) Q_EMIT chosen(pending_file_);
    const QString input = QString::fromStdString(session.input);
    const OpenOptions options = session.options;
    pending_ = std::move(session);
    choice_asked_ = false;
    bench_.loader()->open(input, options);
}

void SessionFeature::askForData(Session session, const QString& file) {
    const auto locate = [this, session, file](bool folder) {
        const QString title = tr("Where is the session's data?");
        const QString name = folder ? file_choice::open_folder(bench_.window(), title, FileKind::volume)
                                    : file_choice::open_file(bench_.window(), title, FileKind::volume, QString());
        if (name.isEmpty()) return;
        Session moved = session;
        moved.input = name.toStdString();
        start(std::move(moved), file);
    };
    const QString lost = preferences::hide_patient()
                             ? tr("The session's data is not where it was. What is open stays open.")
                             : tr("The data of %1 is not where it was (%2). What is open stays open.")
                                   .arg(QFileInfo(file).fileName(), QString::fromStdString(session.input));
    bench_.messages()->ask(lost, {{tr("Locate the folder…"), [locate] { locate(true); }},
                                  {tr("Locate the file…"), [locate] { locate(false); }}});
}

void SessionFeature::documentOpened() {
    if (!write_ || !write_->running()) keepAsLast();  // else it would come after, in the place of the next one's
    ++opened_;
    hash_.cancel();
    sha256_.clear();
    file_.clear();
    const Document& document = bench_.documents()->document();
    std::string expected;
    if (pending_ && pending_->input == document.input && (choice_asked_ || same(pending_->options, document.options))) {
        const Session session = *std::exchange(pending_, std::nullopt);
        try {
            Document shown = document;
            apply_session(session, shown);
            bench_.documents()->restore(shown.settings, shown.camera, shown.cursor_mm);
            expected = session.sha256;
            file_ = pending_file_;
            restoreInspection(session);
            restoreRegions(session);
            Q_EMIT restored();
        } catch (const Error& error) {
            bench_.report(error);
        }
    }
    pending_.reset();
    dirty_ = true;  // what was opened is worth coming back to
    bench_.window()->setWindowModified(false);
    checkVoxels(expected);
}

/// Hashes the voxels beside everything else: sessions are saved with it, and one just opened is held against it.
void SessionFeature::checkVoxels(const std::string& expected) {
    hash_.start(
        [volume = bench_.documents()->document().volume](const JobContext& job) { return voxel_sha256(volume, job); },
        [this, expected](Outcome<std::string> outcome) {
            if (const Error* error = std::get_if<Error>(&outcome)) return bench_.report(*error);
            sha256_ = std::get<0>(outcome);
            if (!expected.empty() && expected != sha256_)
                bench_.messages()->showError(
                    tr("The data changed since this session was saved: its voxels are not the same. Measurements "
                       "and decisions may not fit what is shown; save the session under another name to keep both."));
        });
}

void SessionFeature::restoreInspection(const Session& session) {
    if (session.criteria.empty()) return;
    const Criteria criteria = parse_criteria(session.criteria, session.input);
    inspection_.panel()->setCriteria(criteria);
    // What the session had is found and decided again: that alone changes nothing of it.
    connect(
        &inspection_, &InspectionFeature::finished, this,
        [this, before = changes_, opened = opened_, words = criteria_to_json(criteria), decisions = session.decisions] {
            const auto& found = bench_.documents()->document().inspection;
            if (opened != opened_ || !found || criteria_to_json(inspection_.panel()->form()->criteria()) != words)
                return;
            const auto again = std::count_if(decisions.begin(), decisions.end(), [&](const HandDecision& decision) {
                return decision.defect >= 1 && decision.defect <= found->defects.size();
            });
            if (changes_ == before + 1 + again) bench_.window()->setWindowModified(false);
        },
        Qt::SingleShotConnection);
    inspection_.inspectAgain(criteria.detection, session.decisions);
}

void SessionFeature::restoreRegions(const Session& session) {
    if (!session.regions) return;
    regions_.panel()->setOptions(session.regions->options);
    if (!session.regions->computed) return;
    regions_.computeThen([this, selected = session.regions->selected, cursor = session.cursor_mm] {
        if (selected == 0) return;
        regions_.select(selected);
        bench_.documents()->setCursor(cursor);  // choosing a row goes to its region
    });
}

void SessionFeature::autosave() {
    if (!dirty_ || !write_ || !bench_.documents()->hasDocument()) return;
    dirty_ = false;
    since_autosave_.restart();
    write_->start(
        [session = current(), file = autosave_file_](const JobContext&) {
            save_session(session, file.toStdString());
            return true;
        },
        [this, opened = opened_](Outcome<bool> outcome) {
            if (opened != opened_) keepAsLast();  // of what has left the window since
            if (const Error* error = std::get_if<Error>(&outcome)) {
                dirty_ = true;  // tried again, as when the disk has room again; said once
                if (!std::exchange(autosave_fails_, true)) bench_.report(*error);
                return;
            }
            autosave_fails_ = false;
            Q_EMIT autosaved();
        });
}

/// The autosave of what is leaving the window becomes the last session.
void SessionFeature::keepAsLast() {
    if (QFileInfo::exists(autosave_file_)) make_last(autosave_file_);
}

/// Removes the locks that programs left which ended without the time to do so; one of a living program stays.
void SessionFeature::removeStaleLocks() {
    const QDir folder = autosaveFolder();
    for (const QString& name : folder.entryList({QStringLiteral("autosave-*.lock")}, QDir::Files)) {
        QLockFile lock(folder.filePath(name));
        lock.setStaleLockTime(0);  // as above
        if (lock.tryLock(0)) lock.unlock();
    }
}

void SessionFeature::offerRecovery() {
    removeStaleLocks();
    const QDir folder = autosaveFolder();
    QStringList left;
    for (const QFileInfo& info : folder.entryInfoList({QStringLiteral("autosave-*.lacuna")}, QDir::Files, QDir::Time)) {
        QLockFile owner(folder.filePath(info.completeBaseName() + QStringLiteral(".lock")));
        owner.setStaleLockTime(0);
        if (info.filePath() != autosave_file_ && owner.tryLock(0)) left << info.filePath();
    }
    if (left.isEmpty()) return;
    if (bench_.loader()->loading()) {  // its start would wipe the question away
        connect(bench_.loader(), &LoadController::finished, this, &SessionFeature::offerRecovery,
                Qt::SingleShotConnection);
        return;
    }
    const QString file = left.front();  // another one is offered the next time
    const QString when = QLocale().toString(QFileInfo(file).lastModified(), QLocale::ShortFormat);
    bench_.messages()->ask(tr("Lacuna did not end as it should. What was open was last kept at %1.").arg(when),
                           {{tr("Restore"),
                             [this, file] {
                                 make_last(file);
                                 openFile(lastFile());
                             }},
                            {tr("Discard"), [file] { QFile::remove(file); }}});
}

}  // namespace lacuna::ui
