#pragma once

#include <QDateTime>

#include "ui/features/session_feature.h"
#include "ui/workbench.h"

namespace lacuna::ui {

/// What was opened lately, to be opened again: a menu of the last inputs and sessions, kept as KeptPlaces says. Samples
/// are not kept. While patients' data are hidden, an entry shows what it is and when it was open, not its name. One
/// that is no longer there is said to be so when it is chosen, and leaves the list.
class RecentFeature final : public QObject {
    Q_OBJECT
public:
    struct Entry {
        QString input;        ///< a folder, a file, a session
        QString series, raw;  ///< as OpenOptions holds them
        QDateTime opened;
        bool same_as(const Entry& other) const {
            return input == other.input && series == other.series && raw == other.raw;
        }
    };
    static constexpr int k_most = 10;

    RecentFeature(Workbench& bench, SessionFeature& session);

    const QList<Entry>& entries() const { return entries_; }
    QMenu* menu() const { return menu_; }
    void open(int row);
    void forgetAll();

private:
    void note(const QString& input, const OpenOptions& options = {});
    void keep();
    void fillMenu();
    QString titleOf(const Entry& entry) const;
    void failed(const QString& words);

    Workbench& bench_;
    SessionFeature& session_;
    QMenu* menu_;
    QList<Entry> entries_;  ///< the newest first
    std::optional<Entry> asked_;
};

}  // namespace lacuna::ui
