#pragma once

#include "ui/panels/cuts_panel.h"
#include "ui/views/cut_tool.h"
#include "ui/workbench.h"

namespace lacuna::ui {

/// Cutting planes and the box in the window: their handles in the 3D view, their commands with keys, and the panel that
/// edits the same by numbers. The panel's current cut is the one with handles.
class CutFeature final : public QObject {
    Q_OBJECT
public:
    /// @param panel  the Cuts panel; shown when a cut is added
    CutFeature(Workbench& bench, CutsPanel* panel);
    CutTool* tool() { return &tool_; }
    /// The chosen cut's commands, for a menu over the view: flip, cap or open, remove.
    const QList<QAction*>& cutActions() const { return of_cut_; }
    QAction* boxAction() const { return box_; }

Q_SIGNALS:
    void cutAdded();

private:
    void buildMenu();
    void addMoves(QMenu* menu);
    void addBox(QMenu* menu);
    /// Gives an action's key to the 3D view alone: slices and panels have other uses for it.
    /// @param of_cut  needs a plane that is chosen
    QAction* inView(QAction* action, bool of_cut);
    void show();
    void addFacing();
    void moveBy(int voxels);
    void tiltBy(double right_deg, double up_deg);
    /// Changes the chosen cut; does nothing where there is none.
    template <class Change>
    void editCut(const QString& name, Change&& change);

    Workbench& bench_;
    CutsPanel* panel_;
    CutTool tool_;
    QList<QAction*> of_cut_;
    QAction *open_ = nullptr, *box_ = nullptr;
};

}  // namespace lacuna::ui
