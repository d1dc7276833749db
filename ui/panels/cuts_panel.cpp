#include "ui/panels/cuts_panel.h"

#include <QFormLayout>
#include <QFrame>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "ui/views/slice_annotations.h"

namespace lacuna::ui {

namespace {

glm::dvec3 normal_of(const CutPose& pose) {
    const double a = glm::radians(pose.azimuth_deg), e = glm::radians(pose.elevation_deg);
    return {std::sin(a) * std::cos(e), -std::cos(a) * std::cos(e), std::sin(e)};
}

}  // namespace

CutPose pose_of(const CuttingPlane& plane, const GridGeometry& geometry) {
    const double length = glm::length(plane.normal);
    const glm::dvec3 n = plane.normal / length;
    CutPose pose;
    pose.elevation_deg = glm::degrees(std::asin(std::clamp(n.z, -1.0, 1.0)));
    if (std::hypot(n.x, n.y) > 1e-9) pose.azimuth_deg = glm::degrees(std::atan2(n.x, -n.y));
    pose.distance_mm = -plane.offset / length - glm::dot(n, geometry.centre_mm());
    return pose;
}

CuttingPlane plane_of(const CutPose& pose, bool cap, const GridGeometry& geometry) {
    CuttingPlane plane;
    plane.normal = normal_of(pose);
    plane.offset = -(glm::dot(plane.normal, geometry.centre_mm()) + pose.distance_mm);
    plane.cap = cap;
    return plane;
}

CutsPanel::CutsPanel(QWidget* parent)
    : QWidget(parent),
      list_(new QListWidget(this)),
      add_(new QPushButton(tr("Add a cut"), this)),
      remove_(new QPushButton(tr("Remove"), this)),
      flip_(new QPushButton(tr("Flip side"), this)),
      axes_{new QPushButton(this), new QPushButton(this), new QPushButton(this)},
      azimuth_(new ValueSlider(tr("Azimuth of the cut's normal"), this)),
      elevation_(new ValueSlider(tr("Elevation of the cut's normal"), this)),
      offset_(new ValueSlider(tr("Distance of the cut from the centre"), this)),
      cap_(new QCheckBox(tr("Show data values on the cut face"), this)),
      box_(new BoxPanel(this)) {
    build();
    connect(add_, &QPushButton::clicked, this, &CutsPanel::addCut);
    connect(remove_, &QPushButton::clicked, this, &CutsPanel::removeCurrent);
    connect(flip_, &QPushButton::clicked, this, &CutsPanel::flipCurrent);
    connect(box_, &BoxPanel::edited, this, &CutsPanel::boxEdited);
    connect(axes_[0], &QPushButton::clicked, this, [this] { setAxis(90, 0); });
    connect(axes_[1], &QPushButton::clicked, this, [this] { setAxis(180, 0); });
    connect(axes_[2], &QPushButton::clicked, this, [this] { setAxis(0, -90); });
    const auto pose_edit = [this](double CutPose::*field, const QString& name) {
        return [this, field, name](double value) {
            if (current() < 0) return;
            CutPose pose = currentPose();
            pose.*field = value;
            editPose(name, pose);
        };
    };
    connect(azimuth_, &ValueSlider::valueEdited, this, pose_edit(&CutPose::azimuth_deg, tr("Turn a cut")));
    connect(elevation_, &ValueSlider::valueEdited, this, pose_edit(&CutPose::elevation_deg, tr("Tilt a cut")));
    connect(offset_, &ValueSlider::valueEdited, this, pose_edit(&CutPose::distance_mm, tr("Move a cut")));
    connect(cap_, &QCheckBox::toggled, this, [this](bool on) {
        if (current() < 0) return;
        std::vector<CutSetting> next = cuts_;
        next[std::size_t(current())].plane.cap = on;
        Q_EMIT edited(tr("Cut face"), next);
    });
    connect(list_, &QListWidget::currentRowChanged, this, [this](int cut) {
        showCut();
        Q_EMIT currentChanged(cut);
    });
    connect(list_, &QListWidget::itemChanged, this, [this](QListWidgetItem* item) {
        const std::size_t i = std::size_t(list_->row(item));
        if (i >= cuts_.size()) return;
        std::vector<CutSetting> next = cuts_;
        next[i].enabled = item->checkState() == Qt::Checked;
        Q_EMIT edited(tr("Switch a cut"), next);
    });
    showCut();
}

void CutsPanel::build() {
    list_->setAccessibleName(tr("Cutting planes"));
    list_->setMaximumHeight(84);
    add_->setAccessibleName(tr("Add a cutting plane"));
    remove_->setAccessibleName(tr("Remove the cutting plane"));
    flip_->setAccessibleName(tr("Keep the other side of the cut"));
    nameAxes(AxisNames::patient);
    cap_->setAccessibleName(tr("Show data values on the cut face"));
    cap_->setToolTip(tr("Off: the cut is open and inner surfaces show"));
    azimuth_->setLimits({-180, 180});
    azimuth_->setSuffix(QStringLiteral("°"));
    elevation_->setLimits({-90, 90});
    elevation_->setSuffix(QStringLiteral("°"));
    offset_->setSuffix(QStringLiteral(" mm"));
    auto* column = new QVBoxLayout(this);
    auto* top = new QHBoxLayout;
    top->addWidget(list_, 1);
    auto* buttons = new QVBoxLayout;
    for (QPushButton* button : {add_, remove_, flip_}) buttons->addWidget(button);
    top->addLayout(buttons);
    column->addLayout(top);
    auto* axes = new QHBoxLayout;
    for (QPushButton* button : axes_) axes->addWidget(button);
    column->addLayout(axes);
    auto* form = new QFormLayout;
    form->addRow(tr("Azimuth"), azimuth_);
    form->addRow(tr("Elevation"), elevation_);
    form->addRow(tr("Position"), offset_);
    form->addRow(cap_);
    column->addLayout(form);
    auto* line = new QFrame(this);
    line->setFrameShape(QFrame::HLine);
    line->setFrameShadow(QFrame::Sunken);
    column->addWidget(line);
    column->addWidget(box_);
    column->addStretch(1);
}

/// By the planes that the cuts lie in, each across one of the space's axes.
void CutsPanel::nameAxes(AxisNames names) {
    const bool patient = names == AxisNames::patient;
    const QString words[] = {tr("Cut sagittally"), tr("Cut coronally"), tr("Cut axially")};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const QString title = slice_title(k_slice_kinds[2 - axis], names);
        axes_[axis]->setText(title);
        axes_[axis]->setAccessibleName(patient ? words[axis] : tr("Cut along %1").arg(title));
    }
}

void CutsPanel::setGeometry3d(const GridGeometry& geometry) {
    geometry_ = geometry;
    nameAxes(geometry.axis_names);
    box_->setGeometry3d(geometry);
    cuts_.clear();
    poses_.clear();
    setCuts({});
}

void CutsPanel::setCuts(const std::vector<CutSetting>& cuts) {
    const QSignalBlocker quiet(list_);
    const int before = current();
    const bool grown = cuts.size() > cuts_.size();
    poses_.resize(cuts.size());
    for (std::size_t i = 0; i < cuts.size(); ++i) {
        // A pose edited here is kept as it is; one that came from elsewhere (undo) is derived from the plane.
        const CuttingPlane posed = plane_of(poses_[i], cuts[i].plane.cap, geometry_);
        if (!(glm::length(posed.normal - cuts[i].plane.normal) < 1e-9) ||
            !(std::abs(posed.offset - cuts[i].plane.offset) < 1e-6))
            poses_[i] = pose_of(cuts[i].plane, geometry_);
    }
    cuts_ = cuts;
    while (list_->count() > int(cuts.size())) delete list_->takeItem(list_->count() - 1);
    while (list_->count() < int(cuts.size())) {
        auto* item = new QListWidgetItem(tr("Cut %1").arg(list_->count() + 1));
        item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
        list_->addItem(item);
    }
    for (int i = 0; i < list_->count(); ++i)
        list_->item(i)->setCheckState(cuts[std::size_t(i)].enabled ? Qt::Checked : Qt::Unchecked);
    const int last = int(cuts.size()) - 1;
    list_->setCurrentRow(grown ? last : std::min(std::max(before, 0), last));
    showCut();
    if (current() != before) Q_EMIT currentChanged(current());
}

void CutsPanel::select(int cut) {
    if (!cuts_.empty()) list_->setCurrentRow(int(std::size_t(std::max(cut, 0)) % cuts_.size()));
}

void CutsPanel::removeCurrent() {
    if (current() < 0) return;
    std::vector<CutSetting> next = cuts_;
    next.erase(next.begin() + current());
    Q_EMIT edited(tr("Remove a cut"), next);
}

void CutsPanel::flipCurrent() {
    if (current() < 0) return;
    CutPose pose = currentPose();
    pose.azimuth_deg = std::remainder(pose.azimuth_deg + 180, 360.0);
    pose.elevation_deg = -pose.elevation_deg;
    pose.distance_mm = -pose.distance_mm;
    editPose(tr("Flip a cut"), pose);
}

void CutsPanel::showCut() {
    const bool some = current() >= 0 && std::size_t(current()) < cuts_.size();
    for (QWidget* widget : std::initializer_list<QWidget*>{remove_, flip_, axes_[0], axes_[1], axes_[2], azimuth_,
                                                           elevation_, offset_, cap_})
        widget->setEnabled(some);
    add_->setEnabled(geometry_.size.x > 0 && cuts_.size() < k_max_cuts);
    if (!some) return;
    const CutPose pose = currentPose();
    const double half = half_extent_mm(normal_of(pose), geometry_);
    azimuth_->setValue(pose.azimuth_deg);
    elevation_->setValue(pose.elevation_deg);
    offset_->setLimits({-half, half});
    offset_->setSteps(ValueSteps::of({-half, half}).decimals + 2, geometry_.smallest_spacing_mm());
    offset_->setValue(pose.distance_mm);
    const QSignalBlocker quiet(cap_);
    cap_->setChecked(cuts_[std::size_t(current())].plane.cap);
}

void CutsPanel::editPose(const QString& name, const CutPose& pose) {
    std::vector<CutSetting> next = cuts_;
    CutSetting& cut = next[std::size_t(current())];
    cut.plane = plane_of(pose, cut.plane.cap, geometry_);
    poses_[std::size_t(current())] = pose;
    Q_EMIT edited(name, next);
}

void CutsPanel::setAxis(double azimuth_deg, double elevation_deg) {
    if (current() < 0) return;
    CutPose pose = currentPose();
    pose.azimuth_deg = azimuth_deg;
    pose.elevation_deg = elevation_deg;
    pose.distance_mm = 0;
    editPose(tr("Turn a cut"), pose);
}

void CutsPanel::addCut() {
    if (geometry_.size.x == 0 || cuts_.size() >= k_max_cuts) return;
    std::vector<CutSetting> next = cuts_;
    // The first cut takes the front half away, so that the face is seen from where the camera starts.
    next.push_back({plane_of({180, 0, 0}, true, geometry_), true});
    Q_EMIT edited(tr("Add a cut"), next);
}

}  // namespace lacuna::ui
