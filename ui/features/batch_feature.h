#pragma once

#include <atomic>

#include "ui/dialogs/batch_dialog.h"
#include "ui/workbench.h"

namespace lacuna::ui {

/// A series of parts, inspected beside what the window shows.
class BatchFeature final : public QObject {
    Q_OBJECT
public:
    explicit BatchFeature(Workbench& bench);
    /// Made when it is first asked for.
    BatchDialog* dialog();

private:
    Workbench& bench_;
    BatchDialog* dialog_ = nullptr;
    std::atomic<bool> on_device_ = false;  ///< the window draws by one; else neither does the series
};

}  // namespace lacuna::ui
