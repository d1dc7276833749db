#pragma once

#include "ui/panels/slices_panel.h"
#include "ui/views/slice_cross_hair.h"
#include "ui/workbench.h"

namespace lacuna::ui {

/// How the slices are shown: window presets, slabs, tilted planes, notes in the corners; the commands of it and the
/// cross-hair in the views. The panel is the window's.
class SlicesFeature final : public QObject {
    Q_OBJECT
public:
    SlicesFeature(Workbench& bench, SlicesPanel* panel);

private:
    void addWindows();
    void addSlabs();
    void chooseWindow(ValueRange window);
    void thickenBy(int slices);

    Workbench& bench_;
    SlicesPanel* panel_;
    SliceCrossHair cross_hair_;
    std::vector<QAction*> hounsfield_;
};

}  // namespace lacuna::ui
