// Every dialog, in both languages: each control has a name and is reached by Tab, no letter opens two of them, Escape
// closes.
#include <QAbstractButton>
#include <QAccessible>
#include <QDialogButtonBox>
#include <QDirIterator>
#include <QGroupBox>
#include <QHeaderView>
#include <QLabel>
#include <QRegularExpression>
#include <QTabBar>
#include <QTemporaryDir>
#include <map>
#include <set>

#include "tests/gui/every_dialog.h"
#include "ui/language.h"
#include "ui/preferences.h"

namespace lacuna::ui::test {
namespace {

class DialogsTest : public WindowTest, public testing::WithParamInterface<const char*> {
protected:
    void SetUp() override {
        preferences::set_language(QString::fromLatin1(GetParam()));
        Language::instance()->apply();
        WindowTest::SetUp();
    }
    void TearDown() override {
        window.reset();
        preferences::set_language(QStringLiteral("en"));
        Language::instance()->apply();
    }
    /// Shows each dialog, page after page, and looks at it.
    template <class Look>
    void walk(const Look& look) {
        open(k_casting);
        QTemporaryDir folder;
        for_each_dialog_page(*window, folder.path(), [&](QDialog& dialog, const char* name, int page, int) {
            look(dialog, std::string(name) + " page " + std::to_string(page));
        });
    }
    static bool takesKeys(const QWidget& widget, const QDialog& dialog) {
        if (!(widget.focusPolicy() & Qt::TabFocus) || widget.window() != &dialog || !widget.isVisible()) return false;
        if (widget.objectName().startsWith(QStringLiteral("qt_")) || widget.focusProxy()) return false;
        return !widget.inherits("QHeaderView") && !widget.inherits("QTableCornerButton");
    }
};

TEST_P(DialogsTest, EveryControlHasAName) {
    walk([](QDialog& dialog, const std::string& where) {
        EXPECT_FALSE(dialog.windowTitle().isEmpty() && where.find("palette") == std::string::npos) << where;
        for (QWidget* widget : dialog.findChildren<QWidget*>()) {
            if (!takesKeys(*widget, dialog) || qobject_cast<QTabBar*>(widget)) continue;
            QAccessibleInterface* face = QAccessible::queryAccessibleInterface(widget);
            ASSERT_NE(face, nullptr);
            EXPECT_FALSE(face->text(QAccessible::Name).trimmed().isEmpty())
                << where << ": " << widget->metaObject()->className() << " "
                << widget->property("text").toString().toStdString();
        }
    });
}

TEST_P(DialogsTest, TabReachesEveryControl) {
    walk([](QDialog& dialog, const std::string& where) {
        std::set<QWidget*> reached;
        if (!dialog.focusWidget()) QTest::keyClick(&dialog, Qt::Key_Tab);
        for (int i = 0; i < 120; ++i) {
            QWidget* now = QApplication::focusWidget();
            if (!now || now->window() != &dialog) break;
            reached.insert(now);
            QTest::keyClick(now, Qt::Key_Tab);
        }
        for (QWidget* widget : dialog.findChildren<QWidget*>()) {
            if (!takesKeys(*widget, dialog) || !widget->isEnabled() || widget->inherits("QRadioButton")) continue;
            // Escape does what Close does (below); the log's box of buttons leaves it out of its ring.
            const auto* box = qobject_cast<QDialogButtonBox*>(widget->parentWidget());
            auto* button = qobject_cast<QAbstractButton*>(widget);
            if (box && button && box->standardButton(button) == QDialogButtonBox::Close) continue;
            EXPECT_TRUE(reached.contains(widget))
                << where << ": " << widget->metaObject()->className() << " \"" << widget->accessibleName().toStdString()
                << "\" " << widget->property("text").toString().toStdString();
        }
    });
}

TEST_P(DialogsTest, NoLetterStandsTwice) {
    const auto letter = [](const QString& text) {
        for (qsizetype at = text.indexOf(QLatin1Char('&')); at >= 0 && at + 1 < text.size();
             at = text.indexOf(QLatin1Char('&'), at + 2))
            if (text[at + 1] != QLatin1Char('&')) return text[at + 1].toUpper();
        return QChar();
    };
    walk([&letter](QDialog& dialog, const std::string& where) {
        std::map<QChar, QString> owner;
        const auto note = [&](const QString& text) {
            const QChar one = letter(text);
            if (one.isNull()) return;
            const auto [at, is_new] = owner.emplace(one, text);
            EXPECT_TRUE(is_new) << where << ": \"" << at->second.toStdString() << "\" and \"" << text.toStdString()
                                << "\"";
        };
        for (QWidget* widget : dialog.findChildren<QWidget*>()) {
            if (!widget->isVisible() || widget->window() != &dialog) continue;
            if (auto* button = qobject_cast<QAbstractButton*>(widget)) note(button->text());
            if (auto* label = qobject_cast<QLabel*>(widget); label && label->buddy()) note(label->text());
            if (auto* box = qobject_cast<QGroupBox*>(widget)) note(box->title());
            if (auto* tabs = qobject_cast<QTabBar*>(widget))
                for (int i = 0; i < tabs->count(); ++i) note(tabs->tabText(i));
        }
    });
}

TEST_P(DialogsTest, EscapeClosesEach) {
    walk([](QDialog& dialog, const std::string& where) {
        dialog.show();
        QTest::keyClick(&dialog, Qt::Key_Escape);
        EXPECT_FALSE(dialog.isVisible()) << where;
        dialog.show();
    });
}

/// Words that do not fit are cut off by whoever draws them: buttons, check boxes and labels have to be given their
/// room.
TEST_P(DialogsTest, NoWordsAreCutOff) {
    walk([](QDialog& dialog, const std::string& where) {
        for (QWidget* widget : dialog.findChildren<QWidget*>()) {
            const auto* label = qobject_cast<QLabel*>(widget);
            const bool words = qobject_cast<QAbstractButton*>(widget) || (label && !label->wordWrap());
            if (!words || !widget->isVisible() || widget->property("text").toString().isEmpty()) continue;
            EXPECT_GE(widget->width(), widget->minimumSizeHint().width())
                << where << ": " << widget->property("text").toString().toStdString();
        }
    });
}

INSTANTIATE_TEST_SUITE_P(Languages, DialogsTest, testing::Values("en", "de"));

TEST(Dialogs, NoneOfTheSourcesIsLeftOut) {
    std::set<QString> in_sources;
    const QRegularExpression dialog(QStringLiteral("class (\\w+)(?: final)? : public Q\\w*Dialog\\b"));
    for (QDirIterator files(QStringLiteral(LACUNA_SOURCE_DIR "/ui"), {QStringLiteral("*.h")}, QDir::Files,
                            QDirIterator::Subdirectories);
         files.hasNext();) {
        QFile file(files.next());
        ASSERT_TRUE(file.open(QIODevice::ReadOnly));
        for (auto at = dialog.globalMatch(QString::fromUtf8(file.readAll())); at.hasNext();)
            in_sources.insert(QStringLiteral("lacuna::ui::") + at.next().captured(1));
    }
    EXPECT_GE(in_sources.size(), 11u);
    MainWindow window([](const JobContext&) { return std::make_shared<Engine>(nullptr); });
    QTemporaryDir folder;
    std::set<QString> walked;
    for (const DialogMaker& maker : every_dialog(window, folder.path()))
        walked.insert(QLatin1String(maker.make()->metaObject()->className()));
    EXPECT_EQ(in_sources, walked);
}

}  // namespace
}  // namespace lacuna::ui::test
