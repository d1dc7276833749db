// File dialogs begin where the last one of their kind ended, and what is remembered tells nobody of a patient.
#include <gtest/gtest.h>

#include <QDir>
#include <QFileInfo>
#include <QTemporaryDir>

#include "ui/file_choice.h"
#include "ui/kept_places.h"
#include "ui/preferences.h"

namespace lacuna::ui {
namespace {

class FileChoice : public testing::Test {
protected:
    void SetUp() override { file_choice::forget(); }
    void TearDown() override {
        file_choice::forget();
        preferences::set_hide_patient(false);
        preferences::set_open_folder({});
        preferences::set_save_folder({});
    }
    QString made(const char* name) const {
        QDir(folder.path()).mkpath(QLatin1String(name));
        return folder.filePath(QLatin1String(name));
    }
    QTemporaryDir folder;
};

TEST_F(FileChoice, EachKindHasItsOwnPlaceAndANewOneTakesThatOfAnother) {
    EXPECT_EQ(file_choice::start_folder(FileKind::volume, false), QDir::homePath());
    file_choice::remember(FileKind::volume, false, made("scans"));
    file_choice::remember(FileKind::picture, true, made("pictures"));
    EXPECT_EQ(file_choice::start_folder(FileKind::volume, false), made("scans"));
    EXPECT_EQ(file_choice::start_folder(FileKind::picture, true), made("pictures"));
    EXPECT_EQ(file_choice::start_folder(FileKind::dicom, false), made("scans"));
    EXPECT_EQ(file_choice::start_folder(FileKind::table, true), made("pictures"));
    QDir(made("scans")).removeRecursively();
    EXPECT_EQ(file_choice::start_folder(FileKind::volume, false), QDir::homePath())
        << "one that is gone is passed over";
}

TEST_F(FileChoice, TheFolderChosenInTheSettingsGoesFirst) {
    file_choice::remember(FileKind::volume, false, made("scans"));
    preferences::set_open_folder(made("always"));
    EXPECT_EQ(file_choice::start_folder(FileKind::volume, false), made("always"));
    EXPECT_EQ(file_choice::start_folder(FileKind::volume, true), made("scans"));
    preferences::set_open_folder(folder.filePath(QStringLiteral("gone")));
    EXPECT_EQ(file_choice::start_folder(FileKind::volume, false), made("scans"));
}

TEST_F(FileChoice, TheFileIsTheUsersAloneAndThereIsNoneWherePatientsAreHidden) {
    file_choice::remember(FileKind::volume, false, made("Mueller_Hans"));
    ASSERT_TRUE(QFileInfo::exists(KeptPlaces::file()));
    EXPECT_FALSE(QFileInfo(KeptPlaces::file()).permissions() &
                 (QFile::ReadGroup | QFile::ReadOther | QFile::WriteGroup | QFile::WriteOther));
    preferences::set_hide_patient(true);
    file_choice::remember(FileKind::volume, false, made("Mueller_Ida"));
    EXPECT_FALSE(QFileInfo::exists(KeptPlaces::file()));
    EXPECT_EQ(file_choice::start_folder(FileKind::volume, false), made("Mueller_Ida"));
}

}  // namespace
}  // namespace lacuna::ui
