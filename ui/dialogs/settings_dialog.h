#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QTableWidget>
#include <vector>

#include "core/compute/device.h"
#include "ui/latest_job.h"

namespace lacuna::ui {

/// Everything a person chooses for the program. OK keeps it; what changed is told by signals.
class SettingsDialog final : public QDialog {
    Q_OBJECT
public:
    explicit SettingsDialog(QWidget* parent = nullptr);

    QComboBox* deviceBox() const { return device_; }
    QSpinBox* memoryBox() const { return memory_; }
    QSpinBox* autosaveBox() const { return autosave_; }
    QCheckBox* privacyBox() const { return hide_patient_; }
    QTableWidget* deviceTable() const { return devices_; }
    QPushButton* measureButton() const { return measure_; }
    /// Fills the table and the choice with what was found.
    void showDevices(const std::vector<DeviceInfo>& devices);

public Q_SLOTS:
    void accept() override;
    /// Times every device anew.
    void measure();

Q_SIGNALS:
    void engineChosen();        ///< device or memory limit are others now
    void preferencesChanged();  ///< anything is
    void languageChosen();
    void measured();  ///< the table of devices is filled

private:
    QWidget* generalPage();
    QWidget* computePage();
    QWidget* folderPage();
    QWidget* folderRow(QLineEdit* edit, const QString& title);
    void listDevices(bool again);

    QComboBox *language_, *theme_, *device_;
    QSpinBox *memory_, *autosave_;
    QCheckBox* hide_patient_;
    QLineEdit *open_folder_, *save_folder_;
    QTableWidget* devices_;
    QLabel* why_;
    QPushButton* measure_;
    LatestJob<std::vector<DeviceInfo>> list_job_;
};

}  // namespace lacuna::ui
