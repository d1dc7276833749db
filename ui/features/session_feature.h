#pragma once

#include <QDir>
#include <QLockFile>
#include <QTimer>
#include <deque>
#include <memory>
#include <optional>

#include "core/session/session_file.h"
#include "ui/features/inspection_feature.h"
#include "ui/features/regions_feature.h"
#include "ui/workbench.h"

namespace lacuna::ui {

/// Sessions in the window: save, open, save by itself, and come back after a crash. What was open when a window closed
/// can be opened again.
class SessionFeature final : public QObject {
    Q_OBJECT
public:
    SessionFeature(Workbench& bench, InspectionFeature& inspection, RegionsFeature& regions);
    ~SessionFeature() override;

    /// Reads the file and opens the session's data, both off the window's thread, then shows it as it was left. What is
    /// open stays until the data has been read.
    void openFile(const QString& file);
    /// Writes the open document's session; off the window's thread, because the voxels' hash belongs to it.
    void saveTo(const QString& file);
    /// Writes the session to the user's data folder at once, if anything changed since the last time.
    void autosave();
    /// The window closes: what is open becomes the last session.
    void finish();
    /// The program ends from within, as Qt ends it when its display goes away: what is open is left as after a crash,
    /// to be offered again.
    void keepNow();
    static QDir autosaveFolder();
    static QString lastFile();

public Q_SLOTS:
    void save();
    void saveAs();

Q_SIGNALS:
    void saved(const QString& file);
    void chosen(const QString& file);  ///< a session of the user's own is being opened
    void restored();  ///< a session is shown as it was left, but for an inspection and regions that are found again
    void autosaved();

private:
    void buildMenu();
    void saveNext();
    void changed();
    void moved();
    void documentOpened();
    void restoreInspection(const Session& session);
    void restoreRegions(const Session& session);
    void checkVoxels(const std::string& expected);
    void offerRecovery();
    static void removeStaleLocks();
    void askForData(Session session, const QString& file);
    void start(Session session, const QString& file);
    Session current() const;
    void keepAsLast();

    Workbench& bench_;
    InspectionFeature& inspection_;
    RegionsFeature& regions_;
    std::optional<Session> pending_;  ///< waits for its data
    QString pending_file_;
    /// The load was asked which of several volumes is meant: the answer is not in the session.
    bool choice_asked_ = false;
    QString file_;        ///< where the open session was saved or came from; empty: nowhere yet
    std::string sha256_;  ///< of the open volume; empty: not known yet
    bool dirty_ = false, autosave_fails_ = false;
    int opened_ = 0, changes_ = 0;  ///< documents so far; changes that are asked about
    struct Saving {
        Session session;
        Volume volume;
        QString file;
        int opened = 0, changes = 0;  ///< as opened_ and changes_ were then
    };
    /// What is still to be written, in the order it was asked for; the front is being written. So neither a save into
    /// another file nor the end of the window loses one.
    std::deque<Saving> saving_;
    QTimer autosave_timer_;
    QElapsedTimer since_autosave_, since_change_;
    QString autosave_file_;
    std::unique_ptr<QLockFile> lock_;  ///< tells other windows that the autosave's owner is alive
    struct Found {
        Session session;
        bool data_there = false;
    };
    LatestJob<Found> read_;
    LatestJob<std::string> hash_;
    std::optional<LatestJob<bool>> write_;  ///< until finish()
    std::optional<Task<QString>> save_;     ///< until finish()
};

}  // namespace lacuna::ui
