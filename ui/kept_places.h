#pragma once

#include <QMap>
#include <QString>
#include <QVariantMap>

namespace lacuna::ui {

/// Where somebody works, remembered from run to run: the folders file dialogs ended in, what was opened lately. Such
/// names may be those of patients. So they never stand among the preferences, but in one file that nobody but the user
/// can read; while patients are hidden there is no such file, and what is known ends with the program.
class KeptPlaces final {
public:
    /// The program's one, of the window's thread.
    static KeptPlaces& instance();

    /// Reads what earlier runs kept, or removes it where patients are hidden. What earlier versions kept among the
    /// preferences is taken over once and removed there.
    KeptPlaces();

    /// Values under their names, of one kind of place; empty where nothing is known.
    QVariantMap group(const QString& name) const { return groups_.value(name); }
    /// Replaces the group, in the file too. What other running programs wrote of other groups stays.
    void setGroup(const QString& name, const QVariantMap& values);
    /// Call this when patients were hidden or shown: the file goes, or holds again what is known.
    void keep() const { write(groups_.keys()); }

    static QString file();

private:
    void write(const QStringList& groups) const;

    QMap<QString, QVariantMap> groups_;
};

}  // namespace lacuna::ui
