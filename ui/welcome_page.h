#pragma once

#include <QWidget>

namespace lacuna::ui {

/// What the window shows while nothing is open.
class WelcomePage final : public QWidget {
    Q_OBJECT
public:
    explicit WelcomePage(QWidget* parent = nullptr);

Q_SIGNALS:
    void openFolderRequested();
    void openFileRequested();
    void sampleRequested(const QString& input);
};

}  // namespace lacuna::ui
