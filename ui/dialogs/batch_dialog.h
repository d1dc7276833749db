#pragma once

#include <QCheckBox>
#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QTableView>
#include <condition_variable>
#include <memory>
#include <mutex>

#include "ui/models/batch_model.h"
#include "ui/task.h"

class QFormLayout;
class QToolButton;

namespace lacuna {
class ComputeDevice;
}

namespace lacuna::ui {

/// Inspects a series of parts beside the window: progress a part, pause, cancel, and going on with what stands in the
/// report folder. Closing hides it; the series runs on.
class BatchDialog final : public QDialog {
    Q_OBJECT
public:
    /// Draws the reports' pictures; null: the reference renderer. Asked for on a worker thread when a series starts.
    using DeviceSource = std::function<std::shared_ptr<ComputeDevice>(const JobContext&)>;
    BatchDialog(TaskList* tasks, DeviceSource device, QWidget* parent = nullptr);
    ~BatchDialog() override;

    QLineEdit* partsEdit() const { return parts_; }
    QLineEdit* criteriaEdit() const { return criteria_; }
    QLineEdit* reportEdit() const { return report_; }
    QPushButton* startButton() const { return start_; }
    QPushButton* pauseButton() const { return pause_; }
    QPushButton* cancelButton() const { return cancel_; }
    BatchModel* model() const { return model_; }
    QString messageText() const { return message_->text(); }
    bool running() const { return prepare_.running() || job_.running(); }

Q_SIGNALS:
    void finished();

private:
    /// Holds the workers back while paused; shared with them, because they may outlive the dialog's wish.
    struct Gate {
        std::mutex mutex;
        std::condition_variable_any changed;
        bool paused = false;
    };

    void build();
    void connectButtons();
    QLineEdit* addPathRow(QFormLayout* form, const QString& label, const QString& tip, std::function<QString()> browse);
    struct Prepared {
        BatchOptions options;
        std::vector<BatchPart> parts;
    };
    void prepare();
    void start(Prepared prepared);
    void setPaused(bool paused);
    void showRunning(bool running);
    void tell(const Outcome<BatchResult>& outcome);

    DeviceSource device_;
    QLineEdit *parts_ = nullptr, *criteria_ = nullptr, *report_ = nullptr, *reference_ = nullptr;
    std::vector<QToolButton*> browse_;
    QString summary_;  ///< of the series that ended last
    QSpinBox* jobs_;
    QCheckBox* resume_;
    QPushButton *start_, *pause_, *cancel_, *open_;
    QLabel* message_;
    BatchModel* model_;
    QTableView* table_;
    std::shared_ptr<Gate> gate_;
    Task<Prepared> prepare_;
    Task<BatchResult> job_;
};

}  // namespace lacuna::ui
