#include "ui/panels/transfer_panel.h"

#include <QColorDialog>
#include <QFileDialog>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "ui/tab_chain.h"
#include "ui/widgets/value_slider.h"

namespace lacuna::ui {

TransferPanel::TransferPanel(QWidget* parent)
    : QWidget(parent),
      plot_(new TransferPlot(this)),
      preset_(new QComboBox(this)),
      value_(new QDoubleSpinBox(this)),
      opacity_(new QDoubleSpinBox(this)),
      color_(new QPushButton(tr("Colour…"), this)),
      add_(new QPushButton(tr("Add"), this)),
      remove_(new QPushButton(tr("Remove"), this)),
      load_(new QPushButton(tr("Load…"), this)),
      save_(new QPushButton(tr("Save…"), this)) {
    build();
    connect(plot_, &TransferPlot::functionEdited, this, [this](const TransferFunction& function) {
        showPoint();
        Q_EMIT edited(tr("Transfer function"), function);
    });
    connect(plot_, &TransferPlot::selectionChanged, this, &TransferPanel::showPoint);
    connect(plot_, &TransferPlot::colorRequested, this, &TransferPanel::pickColor);
    connect(value_, &QDoubleSpinBox::valueChanged, this, &TransferPanel::editPoint);
    connect(opacity_, &QDoubleSpinBox::valueChanged, this, &TransferPanel::editPoint);
    connect(color_, &QPushButton::clicked, this, [this] { pickColor(plot_->selected()); });
    connect(add_, &QPushButton::clicked, plot_, &TransferPlot::addPointBeside);
    connect(remove_, &QPushButton::clicked, plot_, &TransferPlot::removeSelected);
    connect(preset_, &QComboBox::activated, this, &TransferPanel::applyPreset);
    connect(load_, &QPushButton::clicked, this, &TransferPanel::load);
    connect(save_, &QPushButton::clicked, this, &TransferPanel::save);
}

void TransferPanel::build() {
    preset_->addItem(tr("Choose a preset…"));
    for (const std::string& name : preset_names()) preset_->addItem(QString::fromStdString(name));
    preset_->setAccessibleName(tr("Transfer function preset"));
    value_->setAccessibleName(tr("Value of the selected point"));
    value_->setKeyboardTracking(false);
    opacity_->setAccessibleName(tr("Opacity of the selected point"));
    opacity_->setRange(0, 1);
    opacity_->setDecimals(3);
    opacity_->setSingleStep(0.02);
    opacity_->setKeyboardTracking(false);
    color_->setAccessibleName(tr("Colour of the selected point"));
    add_->setAccessibleName(tr("Add a point after the selected one"));
    remove_->setAccessibleName(tr("Remove the selected point"));
    load_->setAccessibleName(tr("Load a transfer function file"));
    save_->setAccessibleName(tr("Save the transfer function to a file"));
    auto* column = new QVBoxLayout(this);
    auto* files = new QHBoxLayout;
    files->addWidget(preset_, 1);
    files->addWidget(load_);
    files->addWidget(save_);
    column->addLayout(files);
    column->addWidget(plot_, 1);
    auto* point = new QGridLayout;
    auto* value_label = new QLabel(tr("Val&ue"), this);
    value_label->setBuddy(value_);
    auto* opacity_label = new QLabel(tr("&Opacity"), this);
    opacity_label->setBuddy(opacity_);
    point->addWidget(value_label, 0, 0);
    point->addWidget(value_, 0, 1);
    point->addWidget(opacity_label, 0, 2);
    point->addWidget(opacity_, 0, 3);
    auto* buttons = new QHBoxLayout;
    for (QPushButton* button : {color_, add_, remove_}) buttons->addWidget(button);
    point->addLayout(buttons, 1, 0, 1, 4);
    point->setColumnStretch(1, 1);
    point->setColumnStretch(3, 1);
    column->addLayout(point);
    chain_tabs({preset_, load_, save_, plot_, value_, opacity_, color_, add_, remove_});
}

void TransferPanel::setVolume(const Volume& volume, std::shared_ptr<const VolumeStatistics> statistics) {
    volume_ = volume;
    statistics_ = std::move(statistics);
    plot_->setHistogram(statistics_->histogram, statistics_->histogram_range);
    const ValueSteps steps = ValueSteps::of(statistics_->range);
    const QSignalBlocker quiet(value_);
    const double room = std::max(1.0, statistics_->range.width());
    value_->setDecimals(steps.decimals);
    value_->setSingleStep(steps.step);
    value_->setRange(statistics_->range.lo - room, statistics_->range.hi + room);
    value_->setSuffix(volume.unit.empty() ? QString() : QStringLiteral(" ") + QString::fromStdString(volume.unit));
}

void TransferPanel::setFunction(const TransferFunction& function) {
    plot_->setFunction(function);
    const int known = preset_->findText(QString::fromStdString(function.name));
    preset_->setItemText(
        0, function.name.empty() || known > 0 ? tr("Choose a preset…") : QString::fromStdString(function.name));
    preset_->setCurrentIndex(std::max(0, known));
    showPoint();
}

void TransferPanel::showPoint() {
    const auto& points = plot_->function().points;
    const int i = plot_->selected();
    const bool some = i >= 0 && i < int(points.size());
    for (QWidget* field :
         {static_cast<QWidget*>(value_), static_cast<QWidget*>(opacity_), static_cast<QWidget*>(color_)})
        field->setEnabled(some);
    remove_->setEnabled(some && points.size() > 1);
    if (!some) return;
    const QSignalBlocker quiet_value(value_), quiet_opacity(opacity_);
    value_->setValue(points[std::size_t(i)].value);
    opacity_->setValue(points[std::size_t(i)].opacity);
    QPixmap swatch(16, 16);
    swatch.fill(to_qcolor(points[std::size_t(i)].color));
    color_->setIcon(swatch);
}

void TransferPanel::editPoint() {
    TransferFunction function = plot_->function();
    const std::size_t i = std::size_t(plot_->selected());
    if (i >= function.points.size()) return;
    const auto& points = function.points;
    double value = value_->value();
    if (i > 0) value = std::max(value, points[i - 1].value);
    if (i + 1 < points.size()) value = std::min(value, points[i + 1].value);
    // Fields show rounded numbers; one that was not touched keeps the exact one.
    const double unit = std::pow(10.0, -value_->decimals());
    if (std::abs(value - points[i].value) > 0.5 * unit) function.points[i].value = value;
    if (std::abs(opacity_->value() - points[i].opacity) > 0.0005) function.points[i].opacity = opacity_->value();
    plot_->setFunction(function);
    Q_EMIT edited(tr("Transfer function"), function);
}

void TransferPanel::pickColor(int point) {
    if (point < 0 || point >= int(plot_->function().points.size())) return;
    auto* dialog = new QColorDialog(to_qcolor(plot_->function().points[std::size_t(point)].color), this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setOption(QColorDialog::DontUseNativeDialog);
    dialog->setWindowTitle(tr("Colour of the point"));
    connect(dialog, &QColorDialog::colorSelected, this, [this, point](const QColor& color) {
        TransferFunction function = plot_->function();
        if (point >= int(function.points.size())) return;
        function.points[std::size_t(point)].color = from_qcolor(color);
        plot_->setFunction(function);
        showPoint();
        Q_EMIT edited(tr("Colour of a point"), function);
    });
    dialog->open();
}

void TransferPanel::applyPreset(int index) {
    if (index < 1 || !statistics_) return;
    try {
        const TransferFunction function = make_preset(preset_->itemText(index).toStdString(), volume_, *statistics_);
        plot_->setFunction(function);
        showPoint();
        Q_EMIT edited(tr("Transfer function preset"), function);
    } catch (const Error& error) {
        Q_EMIT failed(QString::fromStdString(error.what()));
    }
}

void TransferPanel::load() {
    const QString file = QFileDialog::getOpenFileName(this, tr("Load a transfer function"), QString(),
                                                      tr("Transfer functions (*.json);;All files (*)"));
    if (file.isEmpty()) return;
    try {
        const TransferFunction function = load_transfer_function(file.toStdString());
        plot_->setFunction(function);
        showPoint();
        Q_EMIT edited(tr("Load a transfer function"), function);
    } catch (const Error& error) {
        Q_EMIT failed(QString::fromStdString(error.what()));
    }
}

void TransferPanel::save() {
    QString file = QFileDialog::getSaveFileName(this, tr("Save the transfer function"), QStringLiteral("colours.json"),
                                                tr("Transfer functions (*.json)"));
    if (file.isEmpty()) return;
    if (!file.contains(QLatin1Char('.'))) file += QStringLiteral(".json");
    try {
        save_transfer_function(plot_->function(), file.toStdString());
    } catch (const Error& error) {
        Q_EMIT failed(QString::fromStdString(error.what()));
    }
}

}  // namespace lacuna::ui
