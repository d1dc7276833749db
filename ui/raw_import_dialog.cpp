#include "ui/raw_import_dialog.h"

#include <QDialogButtonBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QPainter>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "ui/core_sentences.h"
#include "ui/number_text.h"

namespace lacuna::ui {

namespace {

constexpr std::uint64_t k_largest_preview = std::uint64_t(256) << 20;
constexpr VoxelType k_types[] = {VoxelType::u8, VoxelType::i8, VoxelType::u16, VoxelType::i16, VoxelType::f32};

/// A length in mm, down to picometres, with no more zeros than it has.
class SpacingBox final : public NumberBox {
public:
    explicit SpacingBox(QWidget* parent) : NumberBox(parent) {
        setDecimals(9);
        setRange(1e-9, 1000);
        setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    }
    QString textFromValue(double value) const override {
        const QString point(locale().decimalPoint());
        QString text = NumberBox::textFromValue(value);
        if (!text.contains(point)) return text;
        while (text.endsWith(QLatin1Char('0'))) text.chop(1);
        if (text.endsWith(point)) text.chop(point.size());
        return text;
    }
};

QString type_text(VoxelType type) {
    switch (type) {
        case VoxelType::u8:
            return RawImportDialog::tr("8 bit, unsigned");
        case VoxelType::i8:
            return RawImportDialog::tr("8 bit, signed");
        case VoxelType::u16:
            return RawImportDialog::tr("16 bit, unsigned");
        case VoxelType::i16:
            return RawImportDialog::tr("16 bit, signed");
        case VoxelType::f32:
            break;
    }
    return RawImportDialog::tr("32 bit, floating point");
}

QString guess_text(const RawGuess& guess) {
    const glm::ivec3 n = guess.layout.geometry.size;
    QString text = RawImportDialog::tr("%1 × %2 × %3, %4").arg(n.x).arg(n.y).arg(n.z).arg(type_text(guess.layout.type));
    if (size_of(guess.layout.type) > 1)
        text += guess.layout.big_endian ? RawImportDialog::tr(", big endian") : RawImportDialog::tr(", little endian");
    if (guess.layout.offset > 0)
        text += RawImportDialog::tr(", behind %n header bytes", nullptr, int(guess.layout.offset));
    const double percent = 100 * guess.confidence;
    return text + QStringLiteral("  —  ") +
           (percent < 1 ? RawImportDialog::tr("under 1 % sure")
                        : RawImportDialog::tr("%1 % sure").arg(std::lround(percent)));
}

/// One slice as grey values between its percentiles 1 and 99. A short file's missing end stays out of it.
QImage slice_of(RawLayout layout, int z, const JobContext& job) {
    const glm::ivec3 n = layout.geometry.size;
    layout.exact_size = false;
    layout.geometry.size.z = z + 1;
    layout.geometry.spacing = glm::dvec3(1);
    const std::size_t count = std::size_t(n.x) * std::size_t(n.y);
    std::vector<std::byte> bytes(count * size_of(layout.type));
    read_box(open_raw(layout), {{0, 0, z}, {n.x, n.y, 1}}, bytes.data(), job);
    std::vector<float> values(count);
    visit_type(layout.type, [&](auto tag) {
        const auto* from = reinterpret_cast<const decltype(tag)*>(bytes.data());
        for (std::size_t i = 0; i < count; ++i) values[i] = std::isfinite(float(from[i])) ? float(from[i]) : 0.0f;
    });
    job.check();
    std::vector<float> sorted;
    for (std::size_t i = 0; i < count; i += std::max<std::size_t>(1, count / 20000)) sorted.push_back(values[i]);
    std::sort(sorted.begin(), sorted.end());
    const float lo = sorted[sorted.size() / 100], hi = sorted[sorted.size() - 1 - sorted.size() / 100];
    const float scale = hi > lo ? 255 / (hi - lo) : 255;
    QImage image(n.x, n.y, QImage::Format_Grayscale8);
    for (int y = 0; y < n.y; ++y) {
        uchar* line = image.scanLine(y);
        for (int x = 0; x < n.x; ++x)
            line[x] = uchar(
                std::clamp((values[std::size_t(y) * std::size_t(n.x) + std::size_t(x)] - lo) * scale, 0.0f, 255.0f));
    }
    return image;
}

}  // namespace

PicturePreview::PicturePreview(QWidget* parent) : QWidget(parent) {
    setMinimumSize(160, 160);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setAccessibleName(tr("Preview"));
}

void PicturePreview::setImage(const QImage& image, double pixel_aspect) {
    image_ = image;
    aspect_ = pixel_aspect > 0 ? pixel_aspect : 1;
    update();
}

void PicturePreview::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), Qt::black);
    if (image_.isNull()) return;
    QSizeF size(image_.width(), image_.height() * aspect_);
    size.scale(QSizeF(width(), height()), Qt::KeepAspectRatio);
    const QRectF place(QPointF((width() - size.width()) / 2, (height() - size.height()) / 2), size);
    painter.setRenderHint(QPainter::SmoothPixmapTransform, place.width() < image_.width());
    painter.drawImage(place, image_);
}

RawImportDialog::RawImportDialog(const QString& file, QWidget* parent)
    : QDialog(parent),
      file_(file.toStdString()),
      bytes_(std::uint64_t(std::max<qint64>(0, QFileInfo(file).size()))),
      list_(new QListWidget(this)),
      type_(new QComboBox(this)),
      order_(new QComboBox(this)),
      header_(new QSpinBox(this)),
      size_line_(new QLabel(this)),
      preview_(new PicturePreview(this)),
      slice_(new QSlider(Qt::Horizontal, this)),
      slice_text_(new QLabel(this)),
      guess_job_(this),
      preview_job_(this) {
    setWindowTitle(tr("Import %1").arg(QFileInfo(file).fileName()));
    resize(900, 560);
    auto* column = new QVBoxLayout(this);
    auto* row = new QHBoxLayout;
    column->addLayout(row, 1);
    row->addWidget(makeForm(), 1);
    row->addWidget(makePreview(), 1);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Open | QDialogButtonBox::Cancel, this);
    open_ = buttons->button(QDialogButtonBox::Open);
    column->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(this, &QDialog::accepted, this, [this] { Q_EMIT chosen(QString::fromStdString(raw_text(layout()))); });
    showSize();
    propose();
}

QWidget* RawImportDialog::makeForm() {
    auto* box = new QWidget(this);
    auto* form = new QFormLayout(box);
    form->setContentsMargins(0, 0, 0, 0);
    list_->setAccessibleName(tr("Proposals"));
    list_->addItem(tr("Looking at the file…"));
    list_->setMinimumWidth(420);
    auto* proposals = new QLabel(tr("&Proposals, the likeliest first"), box);
    proposals->setBuddy(list_);
    form->addRow(proposals);
    form->addRow(list_);
    connect(list_, &QListWidget::currentRowChanged, this, [this](int row) {
        if (row >= 0 && row < int(guesses_.size())) setLayoutValues(guesses_[std::size_t(row)].layout);
    });
    const QString axes[] = {tr("&Width"), tr("&Height"), tr("&Depth")};
    const QString units[] = {tr(" voxels"), tr(" voxels"), tr(" slices")};
    for (std::size_t a = 0; a < 3; ++a) {
        size_[a] = new QSpinBox(box);
        size_[a]->setRange(1, 1000000);
        size_[a]->setSuffix(units[a]);
        size_[a]->setAccessibleName(QString(axes[a]).remove(QLatin1Char('&')));
        form->addRow(axes[a], size_[a]);
        connect(size_[a], &QSpinBox::valueChanged, this, &RawImportDialog::edited);
    }
    for (const VoxelType type : k_types) type_->addItem(type_text(type));
    type_->setAccessibleName(tr("Voxel type"));
    form->addRow(tr("&Type"), type_);
    order_->addItems({tr("Little endian"), tr("Big endian")});
    order_->setAccessibleName(tr("Byte order"));
    order_->setToolTip(tr("Which byte of a wider number comes first; PCs write little endian"));
    form->addRow(tr("&Byte order"), order_);
    header_->setRange(0, 1 << 30);
    header_->setSuffix(tr(" bytes"));
    header_->setAccessibleName(tr("Header"));
    header_->setToolTip(tr("Bytes before the first voxel"));
    form->addRow(tr("H&eader"), header_);
    addSpacing(form);
    connect(type_, &QComboBox::currentIndexChanged, this, &RawImportDialog::edited);
    connect(order_, &QComboBox::currentIndexChanged, this, &RawImportDialog::edited);
    connect(header_, &QSpinBox::valueChanged, this, &RawImportDialog::edited);
    size_line_->setWordWrap(true);
    size_line_->setAccessibleName(tr("Size of the file"));
    form->addRow(size_line_);
    addHelp(form);
    return box;
}

void RawImportDialog::addSpacing(QFormLayout* form) {
    auto* spacing = new QHBoxLayout;
    const QString names[] = {tr("Spacing between columns"), tr("Spacing between rows"), tr("Spacing between slices")};
    for (std::size_t a = 0; a < 3; ++a) {
        spacing_[a] = new SpacingBox(form->parentWidget());
        spacing_[a]->setValue(1);
        spacing_[a]->setAccessibleName(names[a]);
        spacing_[a]->setToolTip(names[a]);
        spacing->addWidget(spacing_[a]);
        connect(spacing_[a], &QDoubleSpinBox::valueChanged, this, &RawImportDialog::edited);
    }
    auto* spacing_label = new QLabel(tr("&Spacing in mm"), form->parentWidget());
    spacing_label->setBuddy(spacing_[0]);
    form->addRow(spacing_label, spacing);
}

void RawImportDialog::addHelp(QFormLayout* form) {
    auto* help = new QHBoxLayout;
    auto* fit = new QPushButton(tr("&Fit the depth"), form->parentWidget());
    fit->setToolTip(tr("As many slices as the file holds"));
    auto* rest = new QPushButton(tr("The &rest is header"), form->parentWidget());
    rest->setToolTip(tr("Takes all bytes the voxels do not need for a header before them"));
    help->addWidget(fit);
    help->addWidget(rest);
    form->addRow(help);
    for (QPushButton* button : {fit, rest}) button->setAutoDefault(false);
    connect(fit, &QPushButton::clicked, this, &RawImportDialog::fitDepth);
    connect(rest, &QPushButton::clicked, this, &RawImportDialog::restIsHeader);
}

QWidget* RawImportDialog::makePreview() {
    auto* box = new QWidget(this);
    auto* column = new QVBoxLayout(box);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(preview_, 1);
    auto* row = new QHBoxLayout;
    slice_->setAccessibleName(tr("Slice shown"));
    slice_->setToolTip(tr("Slice shown"));
    row->addWidget(slice_, 1);
    row->addWidget(slice_text_);
    column->addLayout(row);
    connect(slice_, &QSlider::valueChanged, this, &RawImportDialog::drawSlice);
    return box;
}

RawLayout RawImportDialog::layout() const {
    RawLayout layout;
    layout.file = file_;
    layout.geometry.size = {size_[0]->value(), size_[1]->value(), size_[2]->value()};
    layout.geometry.spacing = {spacing_[0]->value(), spacing_[1]->value(), spacing_[2]->value()};
    layout.spacing_known = layout.geometry.spacing != glm::dvec3(1);
    layout.type = k_types[std::max(0, type_->currentIndex())];
    layout.big_endian = order_->currentIndex() == 1 && size_of(layout.type) > 1;
    layout.offset = std::uint64_t(header_->value());
    return layout;
}

void RawImportDialog::setLayoutValues(const RawLayout& layout) {
    silent_ = true;
    for (int a = 0; a < 3; ++a) {
        size_[std::size_t(a)]->setValue(layout.geometry.size[a]);
        spacing_[std::size_t(a)]->setValue(layout.geometry.spacing[a]);
    }
    type_->setCurrentIndex(int(std::find(std::begin(k_types), std::end(k_types), layout.type) - std::begin(k_types)));
    order_->setCurrentIndex(layout.big_endian ? 1 : 0);
    header_->setValue(int(std::min<std::uint64_t>(layout.offset, 1 << 30)));
    silent_ = false;
    showSize();
    const QSignalBlocker blocker(slice_);
    slice_->setValue(layout.geometry.size.z / 2);
    drawSlice();
}

void RawImportDialog::propose() {
    guess_job_.start([file = file_](const JobContext& job) { return guess_raw_layouts(file, job); },
                     [this](Outcome<std::vector<RawGuess>> outcome) {
                         if (const Error* error = std::get_if<Error>(&outcome)) {
                             list_->clear();
                             size_line_->setText(core_sentence(error->what()));
                         } else {
                             showProposals(std::get<0>(outcome));
                         }
                         Q_EMIT proposed();
                     });
}

void RawImportDialog::showProposals(const std::vector<RawGuess>& guesses) {
    guesses_ = guesses;
    const QSignalBlocker blocker(list_);
    list_->clear();
    for (const RawGuess& guess : guesses_) {
        auto* item = new QListWidgetItem(guess_text(guess), list_);
        QStringList reasons;
        for (const std::string& reason : guess.reasons) reasons << core_sentence(reason);
        item->setToolTip(reasons.join(QLatin1Char('\n')));
    }
    // The confidence stands at the end of a line: it must not be cut off.
    constexpr int k_narrowest = 420, k_widest = 620;
    const int frame = 2 * list_->frameWidth() + list_->verticalScrollBar()->sizeHint().width();
    list_->setMinimumWidth(std::clamp(list_->sizeHintForColumn(0) + frame, k_narrowest, k_widest));
    if (guesses_.empty()) {
        list_->addItem(tr("Nothing can be told from this file; enter what you know of it."));
        list_->item(0)->setFlags(Qt::NoItemFlags);
        return;
    }
    if (touched_) return;
    list_->setCurrentRow(0);
    setLayoutValues(guesses_.front().layout);
}

void RawImportDialog::edited() {
    if (silent_) return;
    touched_ = true;
    {
        const QSignalBlocker blocker(list_);
        list_->setCurrentRow(-1);
    }
    showSize();
    drawSlice();
}

std::uint64_t RawImportDialog::needed() const {
    const RawLayout now = layout();
    // At most 10^6 voxels an axis, so no product of these overflows.
    return std::uint64_t(now.geometry.size.x) * std::uint64_t(now.geometry.size.y) *
               std::uint64_t(now.geometry.size.z) * size_of(now.type) +
           now.offset;
}

void RawImportDialog::fitDepth() {
    const RawLayout now = layout();
    const std::uint64_t slice =
        std::uint64_t(now.geometry.size.x) * std::uint64_t(now.geometry.size.y) * size_of(now.type);
    const std::uint64_t depth = (bytes_ - std::min(bytes_, now.offset)) / slice;
    size_[2]->setValue(int(std::clamp<std::uint64_t>(depth, 1, 1000000)));
}

void RawImportDialog::restIsHeader() {
    const std::uint64_t voxels = needed() - layout().offset;
    header_->setValue(int(std::min<std::uint64_t>(bytes_ - std::min(bytes_, voxels), 1 << 30)));
}

void RawImportDialog::showSize() {
    const std::uint64_t need = needed();
    QString text = tr("Voxels and header take %1 of the file's %2 bytes").arg(count_text(need), count_text(bytes_));
    if (need > bytes_) text += tr(": %1 too many.").arg(count_text(need - bytes_));
    if (need < bytes_) text += tr(": %1 are left over.").arg(count_text(bytes_ - need));
    if (need == bytes_) text += tr(": it fits.");
    size_line_->setText(text);
    if (open_) open_->setEnabled(need == bytes_ && bytes_ > 0);
    order_->setEnabled(size_of(layout().type) > 1);
    const QSignalBlocker blocker(slice_);
    slice_->setRange(0, size_[2]->value() - 1);
}

void RawImportDialog::drawSlice() {
    const RawLayout now = layout();
    const int z = slice_->value();
    slice_text_->setText(tr("%1 of %2").arg(z + 1).arg(now.geometry.size.z));
    const std::uint64_t slice =
        std::uint64_t(now.geometry.size.x) * std::uint64_t(now.geometry.size.y) * size_of(now.type);
    if (slice > k_largest_preview || now.offset + slice * std::uint64_t(z + 1) > bytes_) {
        preview_job_.cancel();
        preview_->setImage({});
        return;
    }
    preview_job_.start([now, z](const JobContext& job) { return slice_of(now, z, job); },
                       [this, aspect = now.geometry.spacing.y / now.geometry.spacing.x](Outcome<QImage> outcome) {
                           const QImage* image = std::get_if<QImage>(&outcome);
                           preview_->setImage(image ? *image : QImage(), aspect);
                           Q_EMIT previewed();
                       });
}

}  // namespace lacuna::ui
