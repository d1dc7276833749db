#pragma once

#include <QDialog>
#include <QList>
#include <QPair>
#include <QString>

namespace lacuna::ui {

/// What the program is made of: names and versions. @param device  as Engine::device_name() says it
QList<QPair<QString, QString>> version_rows(const QString& device, const QString& driver);

/// What Lacuna is, what it is not (a medical device), and the versions of all it is made of, to be copied into a
/// report.
class AboutDialog final : public QDialog {
    Q_OBJECT
public:
    AboutDialog(const QList<QPair<QString, QString>>& versions, QWidget* parent);
    /// What the copy button copies.
    QString text() const;

private:
    QList<QPair<QString, QString>> versions_;
};

}  // namespace lacuna::ui
