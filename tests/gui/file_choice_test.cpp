// File dialogs begin where the last one of their kind ended, and what is remembered tells nobody of a patient.
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QApplication>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QLineEdit>
#include <QMessageBox>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

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

/// Types `name` into the dialog that save_file opens, and says no where it asks whether to overwrite.
QString saved_as(const QString& name, const QString& filter, bool& asked) {
    asked = false;
    QTimer driver;
    QObject::connect(&driver, &QTimer::timeout, [&, typed = false]() mutable {
        QWidget* modal = QApplication::activeModalWidget();
        if (auto* question = qobject_cast<QMessageBox*>(modal)) {
            asked = true;
            question->button(QMessageBox::No)->click();
        } else if (auto* dialog = qobject_cast<QFileDialog*>(modal)) {
            if (std::exchange(typed, true)) return dialog->reject();
            dialog->selectNameFilter(filter);
            Q_EMIT dialog->filterSelected(filter);
            auto* edit = dialog->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"));
            ASSERT_NE(edit, nullptr);
            edit->setText(name);
            // Not within this timer's turn: it has to tick while the dialog asks.
            QTimer::singleShot(0, edit, [edit] { QTest::keyClick(edit, Qt::Key_Return); });
        }
    });
    driver.start(50);
    return file_choice::save_file(nullptr, QStringLiteral("Save"), FileKind::picture, QStringLiteral("turn.png"),
                                  QStringLiteral("Pictures (*.png);;Films (*.mp4 *.webm)"));
}

TEST_F(FileChoice, ANameWithoutAnEndingGetsOneBeforeAnExistingFileIsAskedAbout) {
    preferences::set_save_folder(made("pictures"));
    const QDir pictures(made("pictures"));
    const QString picture = QStringLiteral("Pictures (*.png)");
    bool asked = false;
    EXPECT_EQ(saved_as(QStringLiteral("a"), picture, asked), pictures.filePath(QStringLiteral("a.png")));
    EXPECT_FALSE(asked);
    EXPECT_EQ(saved_as(QStringLiteral("a.jpg"), picture, asked), pictures.filePath(QStringLiteral("a.jpg")));
    EXPECT_EQ(saved_as(QStringLiteral("a"), QStringLiteral("Films (*.mp4 *.webm)"), asked),
              pictures.filePath(QStringLiteral("a.mp4")));
    QFile there(pictures.filePath(QStringLiteral("b.png")));
    ASSERT_TRUE(there.open(QIODevice::WriteOnly));
    EXPECT_EQ(saved_as(QStringLiteral("b"), picture, asked), QString());
    EXPECT_TRUE(asked);
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
