#pragma once

#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <QWidget>

#include "core/session/document.h"
#include "ui/widgets/range_slider.h"

namespace lacuna::ui {

/// Switches the box on and sets its ends along the volume's axes, in voxels.
class BoxPanel final : public QWidget {
    Q_OBJECT
public:
    explicit BoxPanel(QWidget* parent = nullptr);
    void setGeometry3d(const lacuna::GridGeometry& geometry);
    /// Shows a box; emits nothing.
    void setBox(const lacuna::BoxRoi& box);
    QCheckBox* enabledBox() const { return enabled_; }
    QCheckBox* capBox() const { return cap_; }
    RangeSlider* ends(int axis) const { return ends_[axis]; }

Q_SIGNALS:
    void edited(const QString& name, const lacuna::BoxRoi& box);

private:
    template <class Change>
    void edit(const QString& name, Change&& change);

    BoxRoi box_;
    GridGeometry geometry_;
    QCheckBox *enabled_, *cap_;
    QPushButton* whole_;
    RangeSlider* ends_[3];
    QLabel* facts_[3];
};

}  // namespace lacuna::ui
