#pragma once

#include <QObject>
#include <optional>

#include "ui/preferences.h"
#include "ui/theme.h"

class QApplication;
class QDBusVariant;
class QPalette;

namespace lacuna::ui {

/// What the desktop's wishes come to. @param portal  the value of org.freedesktop.appearance color-scheme: 1 dark,
/// 2 light, 0 no preference; none where nobody answers
/// @param platform  the palette the platform gave the program; its lightness decides where the portal does not. Without
/// a desktop that has a palette of its own the answer is dark: pictures are read in dark rooms.
Scheme system_scheme(std::optional<unsigned> portal, const QPalette& platform, bool has_desktop);

/// Keeps the program's colours as the person chose them, and with the choice "system" as the desktop has them, also
/// when the desktop changes while the program runs (by the XDG desktop portal, over D-Bus; asked without waiting).
class ThemeControl final : public QObject {
    Q_OBJECT
public:
    /// The program's one, made at the first call (before any other apply_theme(), whose palette would be taken for the
    /// platform's) and gone with the QApplication.
    static ThemeControl* instance();
    ThemeChoice choice() const { return choice_; }

public Q_SLOTS:
    /// Changes the colours of everything shown at once and keeps the choice.
    void choose(lacuna::ui::ThemeChoice choice);

Q_SIGNALS:
    void choiceChanged(lacuna::ui::ThemeChoice choice);

private Q_SLOTS:
    void settingChanged(const QString& group, const QString& key, const QDBusVariant& value);

private:
    explicit ThemeControl(QApplication& application);
    void askPortal();
    void take(const QVariant& answer);
    void apply();

    QApplication& application_;
    ThemeChoice choice_;
    std::optional<unsigned> portal_;
    Scheme applied_ = Scheme::dark;
    bool any_ = false;
    Scheme without_portal_;
};

}  // namespace lacuna::ui
