#include "ui/features/recent_feature.h"

#include <QDir>
#include <QFileInfo>
#include <QFontMetrics>
#include <QLocale>

#include "ui/kept_places.h"
#include "ui/preferences.h"

namespace lacuna::ui {

namespace {

constexpr int k_widest_title = 420;  // pixels

bool is_session(const QString& input) { return input.endsWith(QLatin1String(k_session_suffix)); }

const QString k_group = QStringLiteral("recent");

/// "1/input" is the newest entry's input.
QString key_of(int row, const char* what) { return QStringLiteral("%1/%2").arg(row + 1).arg(QLatin1String(what)); }

QList<RecentFeature::Entry> kept_entries() {
    const QVariantMap kept = KeptPlaces::instance().group(k_group);
    QList<RecentFeature::Entry> entries;
    for (int i = 0; i < RecentFeature::k_most; ++i) {
        const auto word = [&](const char* what) { return kept.value(key_of(i, what)).toString(); };
        if (!word("input").isEmpty())
            entries.append({word("input"), word("series"), word("raw"), kept.value(key_of(i, "opened")).toDateTime()});
    }
    return entries;
}

}  // namespace

RecentFeature::RecentFeature(Workbench& bench, SessionFeature& session)
    : QObject(&bench),
      bench_(bench),
      session_(session),
      menu_(bench.submenu(Workbench::Menu::file, tr("Open &recent"))),
      entries_(kept_entries()) {
    menu_->setToolTipsVisible(true);
    connect(bench.documents(), &DocumentController::opened, this, [this] {
        const Document& document = bench_.documents()->document();
        asked_.reset();
        note(QString::fromStdString(document.input), document.options);
    });
    connect(&session, &SessionFeature::saved, this, [this](const QString& file) { note(file); });
    connect(&session, &SessionFeature::chosen, this, [this](const QString& file) { note(file); });
    connect(bench.loader(), &LoadController::failed, this, &RecentFeature::failed);
    // What fails after it is not what was asked for here.
    connect(bench.loader(), &LoadController::started, this, [this](const QString& input) {
        if (asked_ && asked_->input != input) asked_.reset();
    });
    connect(bench.loader(), &LoadController::cancelled, this, [this] { asked_.reset(); });
    // Names may have to be hidden by now.
    connect(menu_, &QMenu::aboutToShow, this, &RecentFeature::fillMenu);
    fillMenu();
}

void RecentFeature::note(const QString& input, const OpenOptions& options) {
    if (input.isEmpty() || input.startsWith(QLatin1String("sample:"))) return;
    const Entry entry{QDir(input).absolutePath(), QString::fromStdString(options.series),
                      QString::fromStdString(options.raw), QDateTime::currentDateTime()};
    entries_.removeIf([&](const Entry& other) { return other.same_as(entry); });
    entries_.prepend(entry);
    while (entries_.size() > k_most) entries_.removeLast();
    keep();
}

void RecentFeature::keep() {
    QVariantMap kept;
    for (int i = 0; i < entries_.size(); ++i) {
        kept[key_of(i, "input")] = entries_[i].input;
        kept[key_of(i, "series")] = entries_[i].series;
        kept[key_of(i, "raw")] = entries_[i].raw;
        kept[key_of(i, "opened")] = entries_[i].opened;
    }
    KeptPlaces::instance().setGroup(k_group, kept);
    fillMenu();
}

QString RecentFeature::titleOf(const Entry& entry) const {
    const QFileInfo file(entry.input);
    if (preferences::hide_patient()) {
        const QString when = QLocale().toString(entry.opened, QLocale::ShortFormat);
        if (is_session(entry.input)) return tr("Session of %1").arg(when);
        return file.suffix().isEmpty() ? tr("Folder of %1").arg(when) : tr("File of %1").arg(when);
    }
    const QString title = file.fileName() + QStringLiteral("  —  ") + QDir::toNativeSeparators(file.path());
    QString shown = QFontMetrics(menu_->font()).elidedText(title, Qt::ElideMiddle, k_widest_title);
    return shown.replace(QLatin1Char('&'), QStringLiteral("&&"));
}

void RecentFeature::fillMenu() {
    menu_->clear();
    for (int i = 0; i < entries_.size(); ++i) {
        // Ten has no digit of its own.
        const QString text = i < 9 ? QStringLiteral("&%1  %2").arg(i + 1).arg(titleOf(entries_[i]))
                                   : QStringLiteral("1&0  %1").arg(titleOf(entries_[i]));
        QAction* action = bench_.addAlways(menu_, text, {}, this, [this, i] { open(i); });
        if (!preferences::hide_patient()) action->setToolTip(QDir::toNativeSeparators(entries_[i].input));
    }
    menu_->addSeparator();
    QAction* forget = bench_.addAlways(menu_, tr("&Forget these"), {}, this, &RecentFeature::forgetAll);
    forget->setEnabled(!entries_.isEmpty());
}

void RecentFeature::open(int row) {
    if (row < 0 || row >= entries_.size()) return;
    const Entry entry = entries_[row];
    if (is_session(entry.input) && QFileInfo::exists(entry.input)) return session_.openFile(entry.input);
    asked_ = entry;
    if (is_session(entry.input)) return failed(tr("There is no file %1.").arg(QFileInfo(entry.input).fileName()));
    OpenOptions options;
    options.series = entry.series.toStdString();
    options.raw = entry.raw.toStdString();
    bench_.loader()->open(entry.input, options);
}

void RecentFeature::failed(const QString& words) {
    const auto asked = std::exchange(asked_, std::nullopt);
    if (!asked || QFileInfo::exists(asked->input)) return;
    entries_.removeIf([&](const Entry& entry) { return entry.same_as(*asked); });
    keep();
    const QString what = preferences::hide_patient() ? tr("What was open then is no longer there.") : words;
    bench_.messages()->showError(what + QLatin1Char(' ') + tr("It has left the list of what was open lately."));
}

void RecentFeature::forgetAll() {
    entries_.clear();
    keep();
}

}  // namespace lacuna::ui
