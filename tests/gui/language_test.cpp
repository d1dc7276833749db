// Translations are complete and fit, and the language changes while the program runs.
#include "ui/language.h"

#include <QAbstractButton>
#include <QFile>
#include <QLabel>
#include <QMenuBar>
#include <QPointer>
#include <QProcess>
#include <QRegularExpression>
#include <QTabBar>
#include <QTemporaryDir>
#include <QXmlStreamReader>
#include <map>
#include <set>

#include "tests/gui/window_fixture.h"
#include "ui/action_catalog.h"
#include "ui/dialogs/about_dialog.h"
#include "ui/dialogs/log_window.h"
#include "ui/dialogs/settings_dialog.h"
#include "ui/dialogs/shortcut_sheet.h"
#include "ui/preferences.h"
#include "ui/workstation.h"

namespace lacuna::ui::test {
namespace {

struct Message {
    QString context, source;
    QStringList translations;
    bool finished = true;
};

QList<Message> read_messages(const QString& path) {
    QFile file(path);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << path.toStdString();
    QXmlStreamReader xml(&file);
    QList<Message> messages;
    QString context;
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement) continue;
        const auto name = xml.name();
        if (name == QLatin1String("name")) context = xml.readElementText();
        if (name == QLatin1String("message")) messages.push_back({context, {}, {}, true});
        if (name == QLatin1String("source")) messages.back().source = xml.readElementText();
        if (name == QLatin1String("translation")) {
            messages.back().finished = !xml.attributes().hasAttribute(QStringLiteral("type"));
            const QString text = xml.readElementText(QXmlStreamReader::IncludeChildElements).trimmed();
            if (!text.isEmpty()) messages.back().translations << text;
        }
    }
    EXPECT_FALSE(xml.hasError()) << xml.errorString().toStdString();
    return messages;
}

QString ts_file(const QString& code) {
    return QStringLiteral(LACUNA_SOURCE_DIR "/resources/translations/lacuna_%1.ts").arg(code);
}

TEST(Translations, NoneIsMissingOrUnfinished) {
    const QList<Message> german = read_messages(ts_file(QStringLiteral("de")));
    EXPECT_GT(german.size(), 500);
    for (const QString& code : Language::codes())
        for (const Message& message : read_messages(ts_file(code)))
            EXPECT_TRUE(message.finished && (!message.translations.isEmpty() || message.source.trimmed().isEmpty()))
                << code.toStdString() << ", " << message.context.toStdString() << ": " << message.source.toStdString();
}

TEST(Translations, HoldEveryTextOfTheSources) {
    QTemporaryDir folder;
    for (const QString& code : Language::codes()) {
        const QString copy = folder.filePath(code + QStringLiteral(".ts"));
        ASSERT_TRUE(QFile::copy(ts_file(code), copy));
        QStringList words{QStringLiteral("-I"),
                          QStringLiteral(LACUNA_SOURCE_DIR),
                          QStringLiteral(LACUNA_SOURCE_DIR "/ui"),
                          QStringLiteral(LACUNA_SOURCE_DIR "/core/accuracy/limits_catalogue.cpp"),
                          QStringLiteral("-ts"),
                          copy};
        if (code == QLatin1String("en")) words.prepend(QStringLiteral("-pluralonly"));
        ASSERT_EQ(QProcess::execute(QStringLiteral(LACUNA_LUPDATE), QStringList{QStringLiteral("-silent")} + words), 0);
        for (const Message& message : read_messages(copy))
            EXPECT_TRUE(message.finished) << "not translated to " << code.toStdString() << ", "
                                          << message.context.toStdString() << ": " << message.source.toStdString();
    }
}

TEST(Translations, KeepPlaceholdersMnemonicsAndDots) {
    const QRegularExpression place(QStringLiteral("%(\\d|n)"));
    const auto places = [&place](const QString& text) {
        std::set<QString> found;
        for (auto at = place.globalMatch(text); at.hasNext();) found.insert(at.next().captured());
        return found;
    };
    const auto mnemonics = [](QString text) { return text.remove(QStringLiteral("&&")).count(QLatin1Char('&')); };
    for (const Message& message : read_messages(ts_file(QStringLiteral("de"))))
        for (const QString& text : message.translations) {
            EXPECT_EQ(places(message.source), places(text)) << message.source.toStdString();
            EXPECT_EQ(mnemonics(message.source), mnemonics(text)) << message.source.toStdString();
            EXPECT_EQ(message.source.endsWith(QChar(0x2026)), text.endsWith(QChar(0x2026)))
                << message.source.toStdString();
        }
}

TEST(Translations, CountOneAndMany) {
    const auto defects = [](int n) {
        return QCoreApplication::translate("lacuna::ui::InspectionPanel", "%n defect(s)", nullptr, n);
    };
    EXPECT_EQ(defects(1), QStringLiteral("1 defect"));
    EXPECT_EQ(defects(3), QStringLiteral("3 defects"));
}

/// Notes what the program asks for in its own words and German does not have.
class MissingTexts final : public QTranslator {
public:
    MissingTexts() { EXPECT_TRUE(german_.load(QStringLiteral(":/i18n/lacuna_de"))); }
    bool isEmpty() const override { return false; }
    QString translate(const char* context, const char* source, const char* comment, int n) const override {
        const QByteArrayView where(context);
        const QString found = german_.translate(context, source, comment, n);
        const bool ours = where.startsWith("lacuna::") || where == "Gestures";
        if (ours && *source && found.isNull())
            missing.insert(QString::fromUtf8(context) + ": " + QString::fromUtf8(source));
        return found;
    }
    mutable std::set<QString> missing;

private:
    QTranslator german_;
};

class LanguageTest : public testing::Test {
protected:
    void SetUp() override {
        preferences::set_language(QStringLiteral("en"));
        Language::instance()->apply();
        workstation =
            std::make_unique<Workstation>([](const JobContext&) { return std::make_shared<Engine>(nullptr); });
        QSignalSpy opened(window()->documents(), &DocumentController::opened);
        window()->resize(1100, 760);
        window()->openInput(k_casting);
        ASSERT_TRUE(opened.wait(k_patience_ms));
        ASSERT_TRUE(QTest::qWaitFor([this] { return window()->bench()->tasks()->rows().empty(); }, k_patience_ms));
    }
    void TearDown() override {
        workstation.reset();
        preferences::set_language(QStringLiteral("en"));
        preferences::forget_window();
        Language::instance()->apply();
    }
    MainWindow* window() const { return workstation->window(); }
    void speak(const QString& code) {
        QSignalSpy made(workstation.get(), &Workstation::windowMade);
        preferences::set_language(code);
        Q_EMIT window()->settingsFeature()->languageChosen();
        ASSERT_TRUE(made.count() > 0 || made.wait(k_patience_ms));
        QApplication::processEvents();
    }
    QStringList menus() const {
        QStringList titles;
        for (QAction* action : window()->menuBar()->actions()) titles << plain_text(action->text());
        return titles;
    }
    std::unique_ptr<Workstation> workstation;
};

TEST_F(LanguageTest, ChangesWithoutARestartAndLosesNothing) {
    window()->views()->setArrangement(Arrangement::one_and_three);
    window()->bench()->edit(QStringLiteral("Isovalue"), [](ViewSettings& s) { s.iso += 10; });
    window()->documents()->undo();
    window()->bench()->edit(QStringLiteral("Quality"), [](ViewSettings& s) { s.quality.step = 1; });
    window()->documents()->setCursor(glm::dvec3(1, 2, 3));
    const Document before = window()->documents()->document();
    const std::shared_ptr<Engine> engine = window()->bench()->engine();
    EXPECT_TRUE(menus().contains(QStringLiteral("View")));
    speak(QStringLiteral("de"));
    EXPECT_TRUE(menus().contains(QStringLiteral("Ansicht"))) << menus().join(' ').toStdString();
    EXPECT_EQ(Language::instance()->code(), QStringLiteral("de"));
    ASSERT_TRUE(window()->documents()->hasDocument());
    const Document& after = window()->documents()->document();
    EXPECT_EQ(after.settings, before.settings);
    EXPECT_EQ(after.cursor_mm, before.cursor_mm);
    EXPECT_EQ(after.camera, before.camera);
    EXPECT_EQ(after.statistics, before.statistics);  // the same voxels, not read again
    EXPECT_EQ(window()->views()->arrangement(), Arrangement::one_and_three);
    EXPECT_EQ(window()->documents()->history().undo_name(), "Quality");
    window()->documents()->undo();
    EXPECT_EQ(window()->documents()->document().settings.quality.step, 0.5);
    ASSERT_TRUE(QTest::qWaitFor([this] { return window()->bench()->engine() != nullptr; }, k_patience_ms));
    EXPECT_EQ(window()->bench()->engine(), engine);
    speak(QStringLiteral("en"));
    EXPECT_TRUE(menus().contains(QStringLiteral("View")));
}

TEST_F(LanguageTest, NoPanelTakesALetterOfTheMenuBar) {
    const auto letter = [](const QString& text) { return QKeySequence::mnemonic(text); };
    for (const char* code : {"de", "en"}) {
        speak(QLatin1String(code));
        window()->rangesPanel()->addRange();
        std::map<QKeySequence, QString> menu;
        for (QAction* action : window()->menuBar()->actions()) {
            ASSERT_FALSE(letter(action->text()).isEmpty()) << action->text().toStdString();
            EXPECT_TRUE(menu.emplace(letter(action->text()), action->text()).second) << action->text().toStdString();
        }
        const auto held = [&](const QWidget* widget, const QString& text) {
            if (widget->window() != window() || letter(text).isEmpty()) return;
            const auto taken = menu.find(letter(text));
            EXPECT_TRUE(taken == menu.end())
                << code << ": " << text.toStdString() << " and " << taken->second.toStdString();
        };
        for (const auto* label : window()->findChildren<QLabel*>())
            if (label->buddy()) held(label, label->text());
        for (const auto* button : window()->findChildren<QAbstractButton*>()) held(button, button->text());
        for (const auto* tabs : window()->findChildren<QTabBar*>())
            for (int i = 0; i < tabs->count(); ++i) held(tabs, tabs->tabText(i));
    }
}

TEST_F(LanguageTest, GermanHasAWordForEverythingAsked) {
    MissingTexts missing;
    QCoreApplication::installTranslator(&missing);
    speak(QStringLiteral("de"));  // whose translator is asked first; what it does not know comes here
    window()->rangesPanel()->addRange();
    window()->cutsPanel()->addCut();
    for (int page = 0; page < window()->tabs()->count(); ++page) window()->tabs()->setCurrentIndex(page);
    for (QTableView* table : window()->findChildren<QTableView*>())
        for (int column = 0; table->model() && column < table->model()->columnCount(); ++column)
            for (const int role : {int(Qt::DisplayRole), int(Qt::ToolTipRole)})
                table->model()->headerData(column, Qt::Horizontal, role);
    SettingsDialog settings;
    LogWindow log_window;
    ShortcutSheet sheet(catalog_of(window()->menuBar()), nullptr);
    AboutDialog about(version_rows({}, {}), nullptr);
    window()->messageBar()->showNotice(QStringLiteral("-"));
    window()->grab();
    QCoreApplication::removeTranslator(&missing);
    for (const QString& text : missing.missing) ADD_FAILURE() << "not translated: " << text.toStdString();
}

TEST_F(LanguageTest, WaitsForRunningJobs) {
    TaskList* tasks = window()->bench()->tasks();
    const TaskList::Id id = tasks->begin(QStringLiteral("long"), [] {});
    QSignalSpy made(workstation.get(), &Workstation::windowMade);
    preferences::set_language(QStringLiteral("de"));
    Q_EMIT window()->settingsFeature()->languageChosen();
    QApplication::processEvents();
    EXPECT_EQ(made.count(), 0);
    EXPECT_TRUE(window()->messageBar()->isVisible());
    tasks->end(id);
    ASSERT_TRUE(made.count() > 0 || made.wait(k_patience_ms));
    EXPECT_TRUE(menus().contains(QStringLiteral("Ansicht")));
}

TEST_F(LanguageTest, WaitsForADialogThatIsBeingAnswered) {
    TaskList* tasks = window()->bench()->tasks();
    const TaskList::Id id = tasks->begin(QStringLiteral("long"), [] {});
    QSignalSpy made(workstation.get(), &Workstation::windowMade);
    preferences::set_language(QStringLiteral("de"));
    Q_EMIT window()->settingsFeature()->languageChosen();
    QApplication::processEvents();
    const QPointer<QDialog> dialog = new QDialog(window());  // as one about a file does, it runs within the window
    QTimer::singleShot(0, dialog, [&] { tasks->end(id); });
    QTimer::singleShot(600, dialog, &QDialog::accept);
    EXPECT_EQ(dialog->exec(), QDialog::Accepted);
    ASSERT_TRUE(dialog) << "the window went from under it";
    EXPECT_EQ(made.count(), 0);
    delete dialog;
    ASSERT_TRUE(made.count() > 0 || made.wait(k_patience_ms));
    EXPECT_TRUE(menus().contains(QStringLiteral("Ansicht")));
}

}  // namespace
}  // namespace lacuna::ui::test
