#include "ui/language.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QPointer>

#include "ui/preferences.h"

/// The library is static: its resources are there only for who asks. Outside of every namespace, as the macro must be.
static void make_translations_known() { Q_INIT_RESOURCE(translations); }

namespace lacuna::ui {

Language* Language::instance() {
    static QPointer<Language> one;
    if (!one) one = new Language(QCoreApplication::instance());
    return one;
}

Language::Language(QObject* parent) : QObject(parent) {
    make_translations_known();
    apply();
}

void Language::apply() {
    QString wanted = preferences::language();
    if (wanted.isEmpty())
        wanted = QLocale::system().language() == QLocale::German ? QStringLiteral("de") : QStringLiteral("en");
    if (wanted == code_) return;
    code_ = wanted;
    for (QTranslator* translator : {&qt_, &own_}) QCoreApplication::removeTranslator(translator);
    // Qt's own words (OK, Cancel, file dialogs) come with Qt where its translations are installed.
    if (qt_.load(QStringLiteral("qtbase_") + wanted, QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
        QCoreApplication::installTranslator(&qt_);
    if (own_.load(QStringLiteral(":/i18n/lacuna_") + wanted)) QCoreApplication::installTranslator(&own_);
    // Numbers in fields are written as the language writes them.
    QLocale::setDefault(QLocale(wanted == QLatin1String("de") ? QLocale::German : QLocale::English));
    Q_EMIT changed();
}

}  // namespace lacuna::ui
