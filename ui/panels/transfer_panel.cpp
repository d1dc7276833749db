#include "ui/panels/transfer_panel.h"

#include <QHBoxLayout>
#include <QLinearGradient>
#include <QMenu>
#include <QPainter>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "core/classify/colour_maps.h"
#include "core/session/preset_settings.h"
#include "core/session/shown_part.h"
#include "ui/colour_map_titles.h"
#include "ui/tab_chain.h"
#include "ui/widgets/plot_paint.h"

namespace lacuna::ui {

namespace {

QIcon swatch_of(const std::string& map) {
    QPixmap picture(64, 14);
    QLinearGradient colors(0, 0, picture.width(), 0);
    for (int i = 0; i <= 16; ++i) colors.setColorAt(i / 16.0, to_qcolor(colour_map_at(map, i / 16.0)));
    QPainter painter(&picture);
    painter.fillRect(picture.rect(), colors);
    return QIcon(picture);
}

}  // namespace

TransferPanel::TransferPanel(QWidget* parent)
    : QWidget(parent),
      histograms_(new HistogramController(this)),
      pages_(new QTabBar(this)),
      stack_(new QStackedWidget(this)),
      plot_(new TransferPlot(this)),
      fields_(new PointFields(plot_, true, this)),
      shapes_note_(
          new QLabel(tr("Shapes of value and gradient are in use: points give the colours of projections."), this)),
      gradients_(new GradientPage(this)),
      shapes_(new ShapesPage(this)),
      target_box_(new QComboBox(this)),
      histogram_box_(new QComboBox(this)),
      logarithmic_(new QCheckBox(tr("&Log"), this)),
      maps_(new QToolButton(this)),
      load_(new QPushButton(tr("Load…"), this)),
      save_(new QPushButton(tr("Save…"), this)) {
    build();
    connectParts();
}

void TransferPanel::build() {
    auto* column = new QVBoxLayout(this);
    auto* files = new QHBoxLayout;
    files->addWidget(target_box_, 1);
    files->addWidget(load_);
    files->addWidget(save_);
    column->addLayout(files);
    target_box_->setAccessibleName(tr("Whose colours are edited"));
    target_box_->setToolTip(tr("The scene's transfer function, or a segmentation range's own"));
    load_->setAccessibleName(tr("Load a transfer function file"));
    save_->setAccessibleName(tr("Save the transfer function to a file"));
    pages_->addTab(tr("Values"));
    pages_->addTab(tr("Gradient"));
    pages_->addTab(tr("Value × gradient"));
    pages_->setExpanding(false);
    pages_->setDrawBase(false);
    pages_->setAccessibleName(tr("What opacity depends on"));
    column->addWidget(pages_);
    auto* values = new QWidget(this);
    auto* values_column = new QVBoxLayout(values);
    values_column->setContentsMargins(0, 0, 0, 0);
    values_column->addWidget(shapes_note_);
    values_column->addWidget(plot_, 1);
    shapes_note_->setWordWrap(true);
    shapes_note_->hide();
    values_column->addWidget(fields_);
    stack_->addWidget(values);
    stack_->addWidget(gradients_);
    stack_->addWidget(shapes_);
    column->addWidget(stack_, 1);
    column->addWidget(buildTools());
    QWidget* before = nullptr;
    QList<QWidget*> chain{target_box_, load_, save_, pages_, plot_};
    chain += fields_->tabChain() + gradients_->tabChain() + shapes_->tabChain() +
             QList<QWidget*>{histogram_box_, logarithmic_, maps_};
    for (QWidget* widget : chain) {
        if (before) setTabOrder(before, widget);
        before = widget;
    }
    fillTargets();
}

QWidget* TransferPanel::buildTools() {
    auto* tools = new QWidget(this);
    auto* row = new QHBoxLayout(tools);
    row->setContentsMargins(0, 0, 0, 0);
    histogram_box_->addItems({tr("Whole volume"), tr("Shown part")});
    histogram_box_->setAccessibleName(tr("What the histogram counts"));
    histogram_box_->setToolTip(tr("Counts all voxels, or those inside the cuts and ranges in use"));
    logarithmic_->setChecked(true);
    logarithmic_->setAccessibleName(tr("Logarithmic histogram"));
    maps_->setText(tr("Colour ma&p"));
    maps_->setPopupMode(QToolButton::InstantPopup);
    maps_->setFocusPolicy(Qt::StrongFocus);
    maps_->setAccessibleName(tr("Give the points the colours of a map"));
    maps_->setToolTip(
        tr("Gives the points the colours of a map: all of them, or those selected where there are several"));
    fillColorMaps();
    row->addWidget(histogram_box_, 1);
    row->addWidget(logarithmic_);
    row->addWidget(maps_);
    return tools;
}

void TransferPanel::fillColorMaps() {
    auto* menu = new QMenu(maps_);
    for (const std::string& name : colour_map_names()) {
        const QString text = QString::fromStdString(name);
        menu->addAction(swatch_of(name), colour_map_title(name), this, [this, text] { applyColorMap(text); });
    }
    menu->addSeparator();
    menu->addAction(tr("Reverse the colours"), this,
                    [this] { edit(tr("Reverse the colours"), with_colours_reversed(function()), true); });
    maps_->setMenu(menu);
}

void TransferPanel::connectParts() {
    connect(plot_, &TransferPlot::functionEdited, this, [this](const TransferFunction& drawn) {
        fields_->refresh();
        edit(tr("Transfer function"), drawn, false);
    });
    connect(plot_, &TransferPlot::gestureEnded, this, &TransferPanel::gestureEnded);
    connect(fields_, &PointFields::functionEdited, this,
            [this](const QString& name, const TransferFunction& drawn) { edit(name, drawn, false); });
    connect(gradients_, &GradientPage::curveEdited, this,
            [this](const QString& name, const std::vector<GradientOpacityPoint>& curve) {
                TransferFunction next = function();
                next.gradient_opacity = curve;
                edit(name, next, false);
            });
    connect(gradients_, &GradientPage::gestureEnded, this, &TransferPanel::gestureEnded);
    connect(shapes_, &ShapesPage::shapesEdited, this,
            [this](const QString& name, const std::vector<TransferShape>& shapes, bool in_use) {
                TransferFunction next = function();
                next.shapes = shapes;
                next.by_shapes = in_use || shapes.empty();
                edit(name, next, false);
            });
    connect(shapes_, &ShapesPage::gestureEnded, this, &TransferPanel::gestureEnded);
    connect(pages_, &QTabBar::currentChanged, this, [this](int page) {
        stack_->setCurrentIndex(page);
        histograms_->setJointWanted(page != k_values);
    });
    connect(target_box_, &QComboBox::activated, this, [this](int index) { setTarget(index - 1); });
    connect(histogram_box_, &QComboBox::activated, this, &TransferPanel::countPart);
    connect(logarithmic_, &QCheckBox::toggled, this, [this](bool on) {
        plot_->setLogarithmic(on);
        gradients_->setLogarithmic(on);
        shapes_->setLogarithmic(on);
    });
    connect(histograms_, &HistogramController::counted, this, [this](const std::vector<std::uint64_t>& counts) {
        plot_->setHistogram(counts, statistics_->histogram_range);
    });
    connect(histograms_, &HistogramController::jointCounted, gradients_, &GradientPage::setJoint);
    connect(histograms_, &HistogramController::jointCounted, shapes_, &ShapesPage::setJoint);
    connect(histograms_, &HistogramController::failed, this, &TransferPanel::failed);
    connect(load_, &QPushButton::clicked, this, &TransferPanel::loadRequested);
    connect(save_, &QPushButton::clicked, this, &TransferPanel::saveRequested);
}

void TransferPanel::setVolume(const Volume& volume, std::shared_ptr<const VolumeStatistics> statistics) {
    volume_ = volume;
    statistics_ = std::move(statistics);
    target_ = -1;
    const double room = std::max(1.0, statistics_->range.width());
    fields_->setLimits({statistics_->range.lo - room, statistics_->range.hi + room},
                       QString::fromStdString(volume.unit));
    const double steepest = statistics_->range.width() / (2 * volume.geometry().smallest_spacing_mm());
    gradients_->setSteepest(steepest);
    shapes_->setSpan(statistics_->histogram_range, steepest);
    histograms_->setVolume(volume, statistics_);
    plot_->showAll();
}

void TransferPanel::setSettings(const ViewSettings& settings) {
    settings_ = settings;
    if (target_ >= int(settings.ranges.size()) || (target_ >= 0 && !settings.ranges[std::size_t(target_)].range.tf))
        target_ = -1;
    fillTargets();
    showFunction();
    countPart();
}

void TransferPanel::fillTargets() {
    const QSignalBlocker quiet(target_box_);
    target_box_->clear();
    target_box_->addItem(tr("Scene's colours"));
    for (const RangeSetting& range : settings_.ranges)
        target_box_->addItem(tr("Colours of %1").arg(QString::fromStdString(range.range.name)));
    target_box_->setCurrentIndex(target_ + 1);
    target_box_->setEnabled(!settings_.ranges.empty());
}

void TransferPanel::setTarget(int index) {
    if (index >= int(settings_.ranges.size())) return;
    target_ = std::max(-1, index);
    if (target_ >= 0 && !settings_.ranges[std::size_t(target_)].range.tf) {
        const QString name = QString::fromStdString(settings_.ranges[std::size_t(target_)].range.name);
        return edit(tr("Own colours of %1").arg(name), settings_.tf, true);
    }
    fillTargets();
    showFunction();
}

void TransferPanel::showPage(Page page) { pages_->setCurrentIndex(page); }

const TransferFunction& TransferPanel::function() const {
    return target_ < 0 ? settings_.tf : *settings_.ranges[std::size_t(target_)].range.tf;
}

ViewSettings TransferPanel::with(const TransferFunction& function) const {
    ViewSettings next = settings_;
    if (target_ < 0)
        next.tf = function;
    else
        next.ranges[std::size_t(target_)].range.tf = function;
    return next;
}

void TransferPanel::edit(const QString& name, const TransferFunction& function, bool whole) {
    if (!statistics_) return;
    if (whole) Q_EMIT gestureEnded();
    Q_EMIT edited(name, with(function));
    if (whole) Q_EMIT gestureEnded();
}

void TransferPanel::showFunction() {
    plot_->setFunction(function());
    fields_->refresh();
    shapes_note_->setVisible(function().is_2d());
    gradients_->setFunction(function());
    shapes_->setFunction(function());
}

void TransferPanel::countPart() {
    histograms_->setPart(histogram_box_->currentIndex() == 0 ? VolumePart{} : shown_part(settings_));
}

void TransferPanel::applyColorMap(const QString& name) {
    if (!statistics_ || function().points.empty()) return;
    const std::set<int>& chosen = plot_->selection();
    const bool several = chosen.size() > 1;
    const std::size_t first = several ? std::size_t(*chosen.begin()) : 0;
    const std::size_t last = several ? std::size_t(*chosen.rbegin()) : function().points.size() - 1;
    edit(tr("Colour map %1").arg(colour_map_title(name.toStdString())),
         with_colour_map(function(), name.toStdString(), first, last), true);
}

void TransferPanel::load(const TransferFunction& function) { edit(tr("Load a transfer function"), function, true); }

}  // namespace lacuna::ui
