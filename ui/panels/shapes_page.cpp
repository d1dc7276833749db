#include "ui/panels/shapes_page.h"

#include <QColorDialog>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "ui/number_text.h"
#include "ui/widgets/plot_paint.h"

namespace lacuna::ui {

namespace {
enum Kind { k_rectangle, k_trapezoid };
}

ShapesPage::ShapesPage(QWidget* parent)
    : QWidget(parent),
      use_(new QCheckBox(tr("Draw &by shapes of value and gradient"), this)),
      plot_(new ShapePlot(this)),
      kind_(new QComboBox(this)),
      opacity_(new NumberBox(this)),
      softness_(new NumberBox(this)),
      color_(new QPushButton(tr("Colour…"), this)),
      add_(new QPushButton(tr("Add"), this)),
      remove_(new QPushButton(tr("Remove"), this)) {
    build();
    connect(use_, &QCheckBox::toggled, this, [this](bool on) {
        if (on && plot_->shapes().empty()) return plot_->addShape();  // which is then in use
        Q_EMIT shapesEdited(on ? tr("Draw by shapes") : tr("Draw by values"), plot_->shapes(), on);
        Q_EMIT gestureEnded();
    });
    connect(plot_, &ShapePlot::shapesEdited, this, [this](const std::vector<TransferShape>& shapes) {
        showShape();
        Q_EMIT shapesEdited(tr("Shapes of value and gradient"), shapes, true);
    });
    connect(plot_, &ShapePlot::gestureEnded, this, &ShapesPage::gestureEnded);
    connect(plot_, &ShapePlot::selectionChanged, this, &ShapesPage::showShape);
    connect(plot_, &ShapePlot::colorRequested, this, &ShapesPage::pickColor);
    connect(kind_, &QComboBox::activated, this, [this](int kind) {
        change(tr("Kind of a shape"), [kind](TransferShape& shape) {
            if (kind == k_rectangle)
                shape.at_hi = shape.at_lo;
            else if (shape.is_rectangle())  // leaning inwards, as surfaces' arches do
                shape.at_hi = {shape.at_lo.lo + 0.25 * shape.at_lo.width(),
                               shape.at_lo.hi - 0.25 * shape.at_lo.width()};
        });
    });
    connect(opacity_, &QDoubleSpinBox::valueChanged, this, [this](double opacity) {
        change(tr("Opacity of a shape"), [opacity](TransferShape& shape) { shape.opacity = opacity; });
    });
    connect(softness_, &QDoubleSpinBox::valueChanged, this, [this](double softness) {
        change(tr("Softness of a shape"), [softness](TransferShape& shape) { shape.softness = softness; });
    });
    connect(color_, &QPushButton::clicked, this, &ShapesPage::pickColor);
    connect(add_, &QPushButton::clicked, plot_, &ShapePlot::addShape);
    connect(remove_, &QPushButton::clicked, plot_, &ShapePlot::removeSelected);
    showShape();
}

void ShapesPage::build() {
    kind_->addItems({tr("Rectangle"), tr("Trapezoid")});
    kind_->setAccessibleName(tr("Kind of the selected shape"));
    for (QDoubleSpinBox* field : {opacity_, softness_}) {
        field->setRange(0, 1);
        field->setDecimals(3);
        field->setSingleStep(0.05);
        field->setKeyboardTracking(false);
    }
    opacity_->setAccessibleName(tr("Opacity of the selected shape"));
    softness_->setAccessibleName(tr("Softness of the selected shape"));
    softness_->setToolTip(tr("Share of the half width over which opacity falls to nothing at either side"));
    color_->setAccessibleName(tr("Colour of the selected shape"));
    add_->setAccessibleName(tr("Add a shape"));
    remove_->setAccessibleName(tr("Remove the selected shape"));
    use_->setToolTip(tr("Opacity and colour come from the shapes below instead of the points and the gradient curve"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(use_);
    column->addWidget(plot_, 1);
    auto* grid = new QGridLayout;
    auto* opacity_label = new QLabel(tr("&Opacity"), this);
    opacity_label->setBuddy(opacity_);
    auto* softness_label = new QLabel(tr("Soft&ness"), this);
    softness_label->setBuddy(softness_);
    grid->addWidget(opacity_label, 0, 0);
    grid->addWidget(opacity_, 0, 1);
    grid->addWidget(softness_label, 0, 2);
    grid->addWidget(softness_, 0, 3);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(kind_, 1);
    for (QPushButton* button : {color_, add_, remove_}) buttons->addWidget(button);
    grid->addLayout(buttons, 1, 0, 1, 4);
    grid->setColumnStretch(1, 1);
    grid->setColumnStretch(3, 1);
    column->addLayout(grid);
}

QList<QWidget*> ShapesPage::tabChain() const {
    return {use_, plot_, opacity_, softness_, kind_, color_, add_, remove_};
}

void ShapesPage::setFunction(const TransferFunction& function) {
    const QSignalBlocker quiet(use_);
    use_->setChecked(function.is_2d());
    plot_->setShapes(function.shapes);
    showShape();
}

void ShapesPage::showShape() {
    const int i = plot_->selected();
    const bool some = i >= 0 && i < int(plot_->shapes().size());
    for (QWidget* widget : QList<QWidget*>{kind_, opacity_, softness_, color_, remove_}) widget->setEnabled(some);
    add_->setEnabled(plot_->shapes().size() < TransferFunction::k_max_shapes);
    if (!some) return;
    const TransferShape& shape = plot_->shapes()[std::size_t(i)];
    const QSignalBlocker quiet[] = {QSignalBlocker(opacity_), QSignalBlocker(softness_)};
    opacity_->setValue(shape.opacity);
    softness_->setValue(shape.softness);
    kind_->setCurrentIndex(shape.is_rectangle() ? k_rectangle : k_trapezoid);
    QPixmap swatch(16, 16);
    swatch.fill(to_qcolor(shape.color));
    color_->setIcon(swatch);
}

template <class Change>
void ShapesPage::change(const QString& name, Change&& apply) {
    const int i = plot_->selected();
    if (i < 0) return;
    std::vector<TransferShape> shapes = plot_->shapes();
    apply(shapes[std::size_t(i)]);
    if (shapes == plot_->shapes()) return;
    plot_->setShapes(shapes);
    showShape();
    Q_EMIT shapesEdited(name, shapes, true);
}

void ShapesPage::pickColor() {
    if (plot_->selected() < 0) return;
    auto* dialog = new QColorDialog(to_qcolor(plot_->shapes()[std::size_t(plot_->selected())].color), this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setOption(QColorDialog::DontUseNativeDialog);
    dialog->setWindowTitle(tr("Colour of the shape"));
    connect(dialog, &QColorDialog::colorSelected, this, [this](const QColor& color) {
        change(tr("Colour of a shape"), [&](TransferShape& shape) { shape.color = from_qcolor(color); });
    });
    dialog->open();
}

}  // namespace lacuna::ui
