// What is remembered of where somebody works tells nobody else of a patient.
#include "ui/kept_places.h"

#include <gtest/gtest.h>

#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QSettings>

#include "tests/gui/window_fixture.h"
#include "ui/features/patient_feature.h"
#include "ui/features/recent_feature.h"
#include "ui/preferences.h"

namespace lacuna::ui::test {
namespace {

const QString k_scan = QStringLiteral("/scans/Mueller_Hans");

/// As versions before this file was used kept what was opened lately.
void write_to_preferences(const QString& input, const QDateTime& opened) {
    QSettings settings;
    settings.beginWriteArray(QStringLiteral("recent"), 1);
    settings.setArrayIndex(0);
    settings.setValue(QStringLiteral("input"), input);
    settings.setValue(QStringLiteral("series"), QStringLiteral("2"));
    settings.setValue(QStringLiteral("opened"), opened);
    settings.endArray();
}

bool among_preferences(const QString& word) {
    QSettings settings;
    settings.sync();
    for (const QString& key : settings.allKeys())
        if (key.contains(word) || settings.value(key).toString().contains(word)) return true;
    QFile file(settings.fileName());
    return file.open(QIODevice::ReadOnly) && file.readAll().contains(word.toUtf8());
}

QByteArray bytes() {
    QFile file(KeptPlaces::file());
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void forget_all() {
    preferences::set_hide_patient(false);
    QSettings().remove(QStringLiteral("recent"));
    for (const char* group : {"recent", "folders"}) KeptPlaces::instance().setGroup(QLatin1String(group), {});
    QFile::remove(KeptPlaces::file());
}

class KeptPlacesTest : public testing::Test {
protected:
    void SetUp() override { forget_all(); }
    void TearDown() override { forget_all(); }
};

TEST_F(KeptPlacesTest, GroupsComeBackAndNobodyElseReadsThem) {
    KeptPlaces first;
    const QDateTime now = QDateTime::currentDateTime();
    first.setGroup(QStringLiteral("recent"), {{QStringLiteral("1/input"), k_scan}, {QStringLiteral("1/opened"), now}});
    KeptPlaces second;
    EXPECT_EQ(second.group(QStringLiteral("recent")), first.group(QStringLiteral("recent")));
    EXPECT_TRUE(second.group(QStringLiteral("folders")).isEmpty());
    // What another program wrote of one group is not lost by writing another.
    second.setGroup(QStringLiteral("folders"), {{QStringLiteral("volume"), QStringLiteral("/scans")}});
    first.setGroup(QStringLiteral("recent"), {});
    const KeptPlaces third;
    EXPECT_TRUE(third.group(QStringLiteral("recent")).isEmpty());
    EXPECT_EQ(third.group(QStringLiteral("folders")).value(QStringLiteral("volume")), QStringLiteral("/scans"));
    EXPECT_FALSE(bytes().contains("Mueller"));
    EXPECT_EQ(QFileInfo(KeptPlaces::file()).permissions() &
                  (QFile::ReadGroup | QFile::ReadOther | QFile::WriteGroup | QFile::WriteOther),
              QFile::Permissions());
}

TEST_F(KeptPlacesTest, WhatStoodAmongThePreferencesIsReadOnceAndRemoved) {
    const QDateTime then(QDate(2026, 3, 4), QTime(5, 6, 7));
    write_to_preferences(k_scan, then);
    ASSERT_TRUE(among_preferences(k_scan));
    QFile before(QFileInfo(KeptPlaces::file()).dir().filePath(QStringLiteral("folders.ini")));
    ASSERT_TRUE(before.open(QIODevice::WriteOnly));
    before.close();
    KeptPlaces places;
    EXPECT_FALSE(among_preferences(k_scan));
    EXPECT_FALSE(before.exists());
    EXPECT_TRUE(bytes().contains("Mueller_Hans"));
    EXPECT_EQ(KeptPlaces().group(QStringLiteral("recent")), places.group(QStringLiteral("recent"))) << "again by file";
    // The menu reads them as they stood.
    KeptPlaces::instance().setGroup(QStringLiteral("recent"), places.group(QStringLiteral("recent")));
    MainWindow window([](const JobContext&) { return std::make_shared<Engine>(nullptr); });
    const auto entries = window.findChild<RecentFeature*>()->entries();
    ASSERT_EQ(entries.size(), 1);
    EXPECT_EQ(entries.front().input, k_scan);
    EXPECT_EQ(entries.front().series, QStringLiteral("2"));
    EXPECT_EQ(entries.front().opened, then);
    // Of two, the file's list is the newer one.
    write_to_preferences(QStringLiteral("/scans/Other"), then);
    EXPECT_EQ(KeptPlaces().group(QStringLiteral("recent")).value(QStringLiteral("1/input")), k_scan);
    EXPECT_FALSE(among_preferences(QStringLiteral("/scans/Other")));
}

TEST_F(KeptPlacesTest, NothingOfEarlierRunsIsReadWherePatientsAreHidden) {
    KeptPlaces::instance().setGroup(QStringLiteral("folders"), {{QStringLiteral("volume"), k_scan}});
    write_to_preferences(k_scan, QDateTime::currentDateTime());
    preferences::set_hide_patient(true);
    const KeptPlaces places;
    EXPECT_TRUE(places.group(QStringLiteral("folders")).isEmpty());
    EXPECT_TRUE(places.group(QStringLiteral("recent")).isEmpty());
    EXPECT_FALSE(QFileInfo::exists(KeptPlaces::file()));
    EXPECT_FALSE(among_preferences(k_scan));
}

class RecentPlaces : public WindowTest {
protected:
    void SetUp() override {
        forget_all();
        WindowTest::SetUp();
    }
    void TearDown() override { forget_all(); }
};

TEST_F(RecentPlaces, TheFileGoesTheMomentPatientsAreHiddenAndComesBackWithThem) {
    const auto recent = [this] { return window->findChild<RecentFeature*>(); };
    const QString session = QDir::temp().filePath(QStringLiteral("Mueller_Hans.lacuna"));
    Q_EMIT window->findChild<SessionFeature*>()->saved(session);
    ASSERT_EQ(recent()->entries().size(), 1);
    EXPECT_TRUE(bytes().contains("Mueller_Hans"));
    EXPECT_FALSE(among_preferences(QStringLiteral("Mueller_Hans")));
    window->patient()->setHidden(true);
    EXPECT_FALSE(QFileInfo::exists(KeptPlaces::file()));
    Q_EMIT window->findChild<SessionFeature*>()->saved(session + QStringLiteral("2.lacuna"));
    EXPECT_FALSE(QFileInfo::exists(KeptPlaces::file()));
    EXPECT_EQ(recent()->entries().size(), 2) << "as long as the program runs";
    EXPECT_TRUE(KeptPlaces().group(QStringLiteral("recent")).isEmpty()) << "but no longer";
    window->patient()->setHidden(false);
    EXPECT_TRUE(bytes().contains("Mueller_Hans"));
}

}  // namespace
}  // namespace lacuna::ui::test
