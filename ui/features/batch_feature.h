#pragma once

#include <atomic>
#include <memory>

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
    /// The window draws by one; else neither does the series, whose thread may ask after this has gone with the window.
    std::shared_ptr<std::atomic<bool>> on_device_ = std::make_shared<std::atomic<bool>>(false);
};

}  // namespace lacuna::ui
