#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <QTranslator>

namespace lacuna::ui {

/// The language of everything shown. English is the source; the other translations are embedded in the program, and
/// English plural forms with them.
class Language final : public QObject {
    Q_OBJECT
public:
    /// The program's one; the first call applies the language kept in the preferences.
    static Language* instance();
    /// "en" or "de": the one in force.
    QString code() const { return code_; }
    static QStringList codes() { return {QStringLiteral("en"), QStringLiteral("de")}; }

public Q_SLOTS:
    /// Takes the language of the preferences (the system's where none is kept). Texts made before stay as they are:
    /// who shows some makes them anew on changed().
    void apply();

Q_SIGNALS:
    void changed();

private:
    explicit Language(QObject* parent);
    QString code_;
    QTranslator own_, qt_;
};

}  // namespace lacuna::ui
