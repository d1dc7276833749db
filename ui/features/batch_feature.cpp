#include "ui/features/batch_feature.h"

#include "core/compute/device.h"
#include "ui/preferences.h"

namespace lacuna::ui {

BatchFeature::BatchFeature(Workbench& bench) : QObject(&bench), bench_(bench) {
    connect(&bench, &Workbench::engineReady, this,
            [this] { *on_device_ = bench_.engine()->device_name() != Engine(nullptr).device_name(); });
    bench.addAlways(bench.menu(Workbench::Menu::tools), tr("Inspect a &series of parts…"),
                    QKeySequence(QStringLiteral("Ctrl+Alt+I")), this, [this] {
                        dialog()->show();
                        dialog()->raise();
                        dialog()->activateWindow();
                    });
}

BatchDialog* BatchFeature::dialog() {
    if (dialog_) return dialog_;
    // A device of its own: the window's pictures do not wait for the series.
    const auto device = [on_device = on_device_](const JobContext& job) -> std::shared_ptr<ComputeDevice> {
        return *on_device ? open_device(preferences::device().toStdString(), job) : nullptr;
    };
    dialog_ = new BatchDialog(bench_.tasks(), device, bench_.window());
    return dialog_;
}

}  // namespace lacuna::ui
