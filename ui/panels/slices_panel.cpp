#include "ui/panels/slices_panel.h"

#include <QCoreApplication>
#include <QFormLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QStandardItemModel>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "ui/number_text.h"

namespace lacuna::ui {

namespace {
// For the translators: the names of hounsfield_windows().
[[maybe_unused]] constexpr const char* k_window_names[] = {
    QT_TRANSLATE_NOOP("WindowPreset", "Brain"),       QT_TRANSLATE_NOOP("WindowPreset", "Abdomen"),
    QT_TRANSLATE_NOOP("WindowPreset", "Bone"),        QT_TRANSLATE_NOOP("WindowPreset", "Lung"),
    QT_TRANSLATE_NOOP("WindowPreset", "Mediastinum"), QT_TRANSLATE_NOOP("WindowPreset", "Angio")};
}  // namespace

QString window_title(const WindowPreset& preset) { return QCoreApplication::translate("WindowPreset", preset.name); }

SlicesPanel::SlicesPanel(QWidget* parent)
    : QWidget(parent),
      preset_(new QComboBox(this)),
      function_(new QComboBox(this)),
      level_(new ValueSlider(tr("Level"), this)),
      width_(new ValueSlider(tr("Window width"), this)),
      slab_mode_(new QComboBox(this)),
      slab_(new ValueSlider(tr("Slab thickness"), this)),
      overlay_(new ValueSlider(tr("Opacity of regions and defects"), this)),
      upright_(new QPushButton(tr("Planes along the grid"), this)),
      projection_(new RangeSlider(this)),
      same_(new QPushButton(tr("As the slices"), this)) {
    build();
    connectSlices();
    connect(preset_, &QComboBox::activated, this, [this](int i) {
        if (i < 1 || std::size_t(i) > windows_.size()) return;
        ViewSettings next = settings_;
        choose(next, windows_[std::size_t(i - 1)]);
        Q_EMIT edited(tr("Window preset"), next);
    });
    connect(level_, &ValueSlider::valueEdited, this,
            [this](double level) { editWindow(level, settings_.window.width()); });
    connect(width_, &ValueSlider::valueEdited, this,
            [this](double width) { editWindow(0.5 * (settings_.window.lo + settings_.window.hi), width); });
    connect(projection_, &RangeSlider::rangeEdited, this, [this](ValueRange range) {
        ViewSettings next = settings_;
        next.projection_window = range;
        Q_EMIT edited(tr("Grey levels of the 3D view"), next);
    });
    connect(same_, &QPushButton::clicked, this, [this] {
        ViewSettings next = settings_;
        next.projection_window = next.window;
        Q_EMIT edited(tr("Grey levels of the 3D view"), next);
    });
}

void SlicesPanel::connectSlices() {
    connect(function_, &QComboBox::activated, this, [this](int i) {
        SliceSettings next = settings_.slices;
        next.function = VoiFunction(i);
        editSlices(tr("Window function"), next);
    });
    connect(slab_mode_, &QComboBox::activated, this, [this](int i) {
        SliceSettings next = settings_.slices;
        next.slab.mode = SlabMode(i);
        editSlices(tr("Slab"), next);
    });
    connect(slab_, &ValueSlider::valueEdited, this, [this](double mm) {
        SliceSettings next = settings_.slices;
        next.slab.thickness_mm = mm;
        editSlices(tr("Slab thickness"), next);
    });
    connect(overlay_, &ValueSlider::valueEdited, this, [this](double percent) {
        SliceSettings next = settings_.slices;
        next.overlay_opacity = percent / 100;
        editSlices(tr("Opacity of the overlay"), next);
    });
    connect(upright_, &QPushButton::clicked, this, [this] {
        SliceSettings next = settings_.slices;
        next.tilt = {1, 0, 0, 0};
        editSlices(tr("Planes along the grid"), next);
    });
}

void SlicesPanel::editSlices(const QString& name, const SliceSettings& slices) {
    ViewSettings next = settings_;
    next.slices = slices;
    Q_EMIT edited(name, next);
}

void SlicesPanel::build() {
    preset_->setAccessibleName(tr("Window preset"));
    function_->setAccessibleName(tr("Window function"));
    function_->addItems({tr("Linear (DICOM)"), tr("Linear, exact"), tr("Sigmoid"), tr("Table of the file")});
    function_->setToolTip(
        tr("How a window makes grey of values: DICOM PS3.3 C.11.2. Linear (DICOM) leaves half a value at either end, "
           "as scanners do; exact runs from end to end; sigmoid fades out softly. A table is the file's own (VOI LUT), "
           "stretched over the window."));
    slab_mode_->setAccessibleName(tr("What a slab shows"));
    slab_mode_->addItems({tr("Mean"), tr("Maximum (MIP)"), tr("Minimum (MinIP)")});
    level_->keepTypedDigits();
    width_->keepTypedDigits();
    slab_->setSuffix(tr(" mm"));
    slab_->setToolTip(tr("How thick the slices are; 0: one voxel"));
    overlay_->setLimits({0, 100});
    overlay_->setSuffix(tr(" %"));
    upright_->setToolTip(
        tr("Ends the tilt of the slices. They are tilted by dragging a handle near the end of a "
           "cross-hair's line, or with Shift and the left button."));
    projection_->setAccessibleName(tr("Grey levels of the 3D view"));
    same_->setAccessibleName(tr("Grey levels of the 3D view as in the slices"));
    auto* column = new QVBoxLayout(this);
    auto* form = new QFormLayout;
    form->addRow(tr("&Window"), preset_);
    form->addRow(tr("Level"), level_);
    form->addRow(tr("Width"), width_);
    form->addRow(tr("Fun&ction"), function_);
    form->addRow(tr("S&lab"), slab_mode_);
    form->addRow(tr("Thickness"), slab_);
    form->addRow(tr("Overlay"), overlay_);
    form->addRow(QString(), upright_);
    column->addLayout(form);
    auto* title = new QLabel(tr("Grey levels of projections and cut faces in 3D"), this);
    title->setContentsMargins(0, 10, 0, 0);
    column->addWidget(title);
    column->addWidget(projection_);
    column->addWidget(same_, 0, Qt::AlignLeft);
    column->addStretch(1);
}

void SlicesPanel::setDocument(const Document& document) {
    const Volume& volume = document.volume;
    statistics_ = document.statistics;
    unit_ = volume.unit;
    own_ = default_window(volume, *statistics_);
    const ValueRange values = statistics_->range;
    const double span = std::max(values.width(), 1e-6);
    ValueRange reach{std::min(values.lo, own_.lo), std::max(values.hi, own_.hi)};
    double widest = std::max(2 * span, own_.width());
    for (const auto& table : document.voi_tables) {
        reach = {std::min(reach.lo, table->first), std::max(reach.hi, table->last())};
        widest = std::max(widest, table->last() - table->first);
    }
    level_->setLimits(reach);
    width_->setLimits({span / 1000, widest});
    projection_->setLimits({std::min(values.lo, own_.lo), std::max(values.hi, own_.hi)});
    projection_->setStep(ValueSteps::of(values).step);
    const GridGeometry& geometry = volume.geometry();
    const double extent = geometry.diameter_mm() / 2;
    slab_->setLimits({0, extent});
    slab_->setSteps(ValueSteps::of({0, extent}).decimals, geometry.smallest_spacing_mm());
    fillPresets(document);
}

void SlicesPanel::choose(ViewSettings& settings, const NamedWindow& window) {
    settings.window = window.range;
    if (window.table) {
        settings.slices.function = VoiFunction::table;
        settings.slices.table = *window.table;
    } else if (settings.slices.function == VoiFunction::table) {
        settings.slices.function = VoiFunction::linear;  // what windows of DICOM files mean
    }
}

void SlicesPanel::fillPresets(const Document& document) {
    const ValueRange& all = statistics_->range;
    windows_ = {{tr("As opened"), own_, {}},
                {tr("Full range"), all.width() > 0 ? all : ValueRange{all.lo - 0.5, all.lo + 0.5}, {}}};
    if (unit_ == "HU")
        for (const WindowPreset& preset : hounsfield_windows())
            windows_.push_back({tr("%1 (L %2, W %3)")
                                    .arg(window_title(preset))
                                    .arg(number_text(preset.center), number_text(preset.width)),
                                ValueRange{preset.center - 0.5 * preset.width, preset.center + 0.5 * preset.width},
                                {}});
    for (std::size_t i = 0; i < document.voi_tables.size(); ++i) {
        const VoiTable& table = *document.voi_tables[i];
        const QString name = table.name.empty() ? tr("Table %1 of the file").arg(i + 1)
                                                : tr("%1 (table of the file)").arg(QString::fromStdString(table.name));
        windows_.push_back({name, ValueRange{table.first, table.last()}, int(i)});
    }
    // What LoadController opens it with.
    if (!document.voi_tables.empty() && document.volume.dicom && !document.volume.dicom->window_center) {
        const VoiTable& table = *document.voi_tables.front();
        windows_.front() = {windows_.front().name, {table.first, table.last()}, 0};
    }
    setTablesAllowed(!document.voi_tables.empty());
    const QSignalBlocker quiet(preset_);
    preset_->clear();
    preset_->addItem(tr("Custom"));
    for (const NamedWindow& window : windows_) preset_->addItem(window.name);
}

void SlicesPanel::setTablesAllowed(bool there) {
    auto* model = qobject_cast<QStandardItemModel*>(function_->model());
    if (model) model->item(int(VoiFunction::table))->setEnabled(there);
}

void SlicesPanel::setSettings(const ViewSettings& settings) {
    settings_ = settings;
    const QSignalBlocker quiet(preset_);
    int chosen = 0;
    const bool by_table = settings.slices.function == VoiFunction::table;
    for (std::size_t i = 0; i < windows_.size() && chosen == 0; ++i)
        if (windows_[i].range == settings.window && windows_[i].table.has_value() == by_table &&
            windows_[i].table.value_or(settings.slices.table) == settings.slices.table)
            chosen = int(i) + 1;
    preset_->setCurrentIndex(chosen);
    level_->setValue(0.5 * (settings.window.lo + settings.window.hi));
    width_->setValue(settings.window.width());
    const SliceSettings& slices = settings.slices;
    function_->setCurrentIndex(int(slices.function));
    slab_mode_->setCurrentIndex(int(slices.slab.mode));
    slab_->setValue(slices.slab.thickness_mm);
    overlay_->setValue(100 * slices.overlay_opacity);
    upright_->setEnabled(std::abs(slices.tilt.w) < 1);
    if (projection_->range() != settings.projection_window) projection_->setRange(settings.projection_window);
}

void SlicesPanel::editWindow(double level, double width) {
    ViewSettings next = settings_;
    next.window = {level - 0.5 * width, level + 0.5 * width};
    Q_EMIT edited(tr("Window and level"), next);
}

}  // namespace lacuna::ui
