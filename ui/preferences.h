#pragma once

#include <QByteArray>
#include <QString>

namespace lacuna::ui {

enum class ThemeChoice { system, dark, light };

/// What a person has chosen for the program and not for a volume. Each value is read from and written to QSettings at
/// once; a value out of its limits reads as its default. Patient data never goes in here.
namespace preferences {

ThemeChoice theme();
void set_theme(ThemeChoice choice);

/// "en", "de", or empty: the system's.
QString language();
void set_language(const QString& code);

/// As open_device() takes it: empty for the fastest, "none", a number or a part of a name.
QString device();
void set_device(const QString& choice);

/// MiB of host and device memory; 0: 75 % of the machine's.
int memory_limit_mib();
void set_memory_limit_mib(int mib);

/// Whether names, identifiers and dates of patients are kept off the screen.
bool hide_patient();
void set_hide_patient(bool hide);

/// Minutes between two automatic saves of the session, 1 to 60; 0: none.
int autosave_minutes();
void set_autosave_minutes(int minutes);

/// Where file dialogs for opening and for writing start; empty: where the last one was (file_choice.h).
QString open_folder();
void set_open_folder(const QString& folder);
QString save_folder();
void set_save_folder(const QString& folder);

/// The window's place and docks, as QMainWindow::saveGeometry() and saveState() give them.
QByteArray window_geometry();
QByteArray window_state();
void set_window(const QByteArray& geometry, const QByteArray& state);
void forget_window();

/// The arrangement of the views, as FourUp::saveState() gives it.
QByteArray views_state();
void set_views_state(const QByteArray& state);

/// Whether the 3D view turns freely as a ball, not as a turntable.
bool free_rotation();
void set_free_rotation(bool free);

}  // namespace preferences

/// Gives the program its name, under which QSettings keeps the preferences. Call it before any of the above.
void name_application(const QString& version);

}  // namespace lacuna::ui
