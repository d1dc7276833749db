#include "ui/theme_control.h"

#include <QApplication>
#include <QDBusConnection>
#include <QDBusMessage>
#include <QDBusPendingCallWatcher>
#include <QDBusPendingReply>
#include <QDBusVariant>
#include <QPalette>
#include <QPointer>

namespace lacuna::ui {

namespace {
constexpr char k_service[] = "org.freedesktop.portal.Desktop", k_path[] = "/org/freedesktop/portal/desktop",
               k_face[] = "org.freedesktop.portal.Settings", k_group[] = "org.freedesktop.appearance",
               k_key[] = "color-scheme";

bool is_dark(const QPalette& palette) {
    return palette.color(QPalette::Window).lightness() < palette.color(QPalette::WindowText).lightness();
}
}  // namespace

Scheme system_scheme(std::optional<unsigned> portal, const QPalette& platform, bool has_desktop) {
    if (portal == 1u) return Scheme::dark;
    if (portal == 2u) return Scheme::light;
    return !has_desktop || is_dark(platform) ? Scheme::dark : Scheme::light;
}

ThemeControl* ThemeControl::instance() {
    static QPointer<ThemeControl> one;
    if (!one) one = new ThemeControl(*qApp);
    return one;
}

ThemeControl::ThemeControl(QApplication& application)
    : QObject(&application),
      application_(application),
      choice_(preferences::theme()),
      without_portal_(system_scheme({}, QApplication::palette(), qEnvironmentVariableIsSet("XDG_CURRENT_DESKTOP"))) {
    apply();
    // Without a session bus of this desktop nobody is asked: looking for one could start one.
    if (qEnvironmentVariableIsSet("DBUS_SESSION_BUS_ADDRESS")) askPortal();
}

void ThemeControl::askPortal() {
    QDBusConnection bus = QDBusConnection::sessionBus();
    if (!bus.isConnected()) return;
    bus.connect(QLatin1String(k_service), QLatin1String(k_path), QLatin1String(k_face),
                QStringLiteral("SettingChanged"), this, SLOT(settingChanged(QString, QString, QDBusVariant)));
    QDBusMessage call = QDBusMessage::createMethodCall(QLatin1String(k_service), QLatin1String(k_path),
                                                       QLatin1String(k_face), QStringLiteral("Read"));
    call << QString::fromLatin1(k_group) << QString::fromLatin1(k_key);
    auto* watcher = new QDBusPendingCallWatcher(bus.asyncCall(call), this);
    connect(watcher, &QDBusPendingCallWatcher::finished, this, [this, watcher] {
        const QDBusPendingReply<QDBusVariant> reply = *watcher;
        if (reply.isValid()) take(reply.value().variant());
        watcher->deleteLater();
    });
}

void ThemeControl::settingChanged(const QString& group, const QString& key, const QDBusVariant& value) {
    if (group == QLatin1String(k_group) && key == QLatin1String(k_key)) take(value.variant());
}

void ThemeControl::take(const QVariant& answer) {
    // Read() wraps its value in a variant of its own; the signal does not.
    const QVariant inner = answer.canConvert<QDBusVariant>() ? answer.value<QDBusVariant>().variant() : answer;
    bool is_number = false;
    const unsigned value = inner.toUInt(&is_number);
    if (!is_number) return;
    portal_ = value;
    apply();
}

void ThemeControl::choose(ThemeChoice choice) {
    if (choice == choice_) return;
    choice_ = choice;
    preferences::set_theme(choice);
    apply();
    Q_EMIT choiceChanged(choice);
}

void ThemeControl::apply() {
    const Scheme system = portal_ == 1u ? Scheme::dark : portal_ == 2u ? Scheme::light : without_portal_;
    const Scheme wanted = choice_ == ThemeChoice::dark    ? Scheme::dark
                          : choice_ == ThemeChoice::light ? Scheme::light
                                                          : system;
    if (any_ && wanted == applied_) return;
    any_ = true;
    applied_ = wanted;
    apply_theme(application_, wanted);
}

}  // namespace lacuna::ui
