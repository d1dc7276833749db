#include "ui/panels/box_panel.h"

#include <QGridLayout>
#include <QSignalBlocker>
#include <cmath>

#include "core/volume/axis_names.h"

namespace lacuna::ui {

BoxPanel::BoxPanel(QWidget* parent)
    : QWidget(parent),
      enabled_(new QCheckBox(tr("Show a box of the volume alone"), this)),
      cap_(new QCheckBox(tr("Data values on the box's sides"), this)),
      whole_(new QPushButton(tr("Whole volume"), this)) {
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setColumnStretch(1, 1);
    grid->addWidget(enabled_, 0, 0, 1, 3);
    enabled_->setAccessibleName(tr("Show a box of the volume alone"));
    enabled_->setToolTip(tr("Cuts away what lies outside the box; drag its sides in the 3D view"));
    cap_->setAccessibleName(tr("Show data values on the box's sides"));
    cap_->setToolTip(tr("Off: the box is open and inner surfaces show"));
    whole_->setAccessibleName(tr("Make the box as large as the volume"));
    for (int axis = 0; axis < 3; ++axis) {
        ends_[axis] = new RangeSlider(this);
        ends_[axis]->setStep(1);
        facts_[axis] = new QLabel(this);
        facts_[axis]->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("0000–0000")));
        facts_[axis]->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        auto* name = new QLabel(this);
        name->setObjectName(QStringLiteral("axis%1").arg(axis));
        grid->addWidget(name, 1 + axis, 0);
        grid->addWidget(ends_[axis], 1 + axis, 1);
        grid->addWidget(facts_[axis], 1 + axis, 2);
        connect(ends_[axis], &RangeSlider::rangeEdited, this, [this, axis](ValueRange range) {
            edit(tr("Box"), [&](BoxRoi& box) {
                const double cells = geometry_.size[axis];
                // A slider's ends may meet; a box keeps a voxel.
                const double lo = std::min(range.lo, cells - 1);
                box.lo[axis] = lo / cells;
                box.hi[axis] = std::max(range.hi, lo + 1) / cells;
            });
        });
    }
    grid->addWidget(cap_, 4, 0, 1, 3);
    grid->addWidget(whole_, 5, 0, 1, 3, Qt::AlignLeft);
    connect(enabled_, &QCheckBox::toggled, this,
            [this](bool on) { edit(tr("Switch the box"), [on](BoxRoi& box) { box.enabled = on; }); });
    connect(cap_, &QCheckBox::toggled, this,
            [this](bool on) { edit(tr("Sides of the box"), [on](BoxRoi& box) { box.cap = on; }); });
    connect(whole_, &QPushButton::clicked, this, [this] {
        edit(tr("Box"), [](BoxRoi& box) {
            box.lo = glm::dvec3(0);
            box.hi = glm::dvec3(1);
        });
    });
    setBox({});
}

template <class Change>
void BoxPanel::edit(const QString& name, Change&& change) {
    BoxRoi next = box_;
    change(next);
    Q_EMIT edited(name, next);
}

void BoxPanel::setGeometry3d(const GridGeometry& geometry) {
    geometry_ = geometry;
    for (int axis = 0; axis < 3; ++axis) {
        const QString name = QString::fromStdString(axis_span(geometry.axis_names, geometry.direction[axis]));
        findChild<QLabel*>(QStringLiteral("axis%1").arg(axis))->setText(name);
        ends_[axis]->setLimits({0, double(std::max(1, geometry.size[axis]))});
        ends_[axis]->setAccessibleName(tr("Ends of the box from %1, in voxels").arg(name));
    }
    setBox(box_);
}

void BoxPanel::setBox(const BoxRoi& box) {
    box_ = box;
    const QSignalBlocker quiet[] = {QSignalBlocker(enabled_), QSignalBlocker(cap_)};
    enabled_->setChecked(box.enabled);
    cap_->setChecked(box.cap);
    for (QWidget* widget : std::initializer_list<QWidget*>{cap_, whole_, ends_[0], ends_[1], ends_[2]})
        widget->setEnabled(box.enabled);
    for (int axis = 0; axis < 3; ++axis) {
        const double cells = std::max(1, geometry_.size[axis]);
        ends_[axis]->setRange({box.lo[axis] * cells, box.hi[axis] * cells});
        facts_[axis]->setText(QStringLiteral("%1–%2")
                                  .arg(int(std::lround(box.lo[axis] * cells)) + 1)
                                  .arg(int(std::lround(box.hi[axis] * cells))));
    }
}

}  // namespace lacuna::ui
