#include "ui/status_line.h"

#include <algorithm>

namespace lacuna::ui {

StatusLine::StatusLine(QWidget* parent)
    : QStatusBar(parent),
      readout_(new QLabel(this)),
      what_(new QLabel(this)),
      frame_(new QLabel(this)),
      device_(new QLabel(this)),
      bar_(new QProgressBar(this)),
      cancel_(new QPushButton(tr("Cancel"), this)) {
    setSizeGripEnabled(false);
    setContentsMargins(8, 0, 8, 0);
    readout_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);  // its text never widens the window
    readout_->setAccessibleName(tr("Value under the cursor"));
    frame_->setAccessibleName(tr("Last frame"));
    device_->setAccessibleName(tr("Device"));
    bar_->setAccessibleName(tr("Progress"));
    bar_->setFixedWidth(160);
    bar_->setMaximumHeight(16);
    cancel_->setAccessibleName(tr("Cancel the running job"));
    cancel_->setToolTip(tr("Stops what is running (Ctrl+.)"));
    cancel_->setShortcut(QKeySequence(QStringLiteral("Ctrl+.")));
    addWidget(readout_, 1);
    addWidget(what_);
    addWidget(bar_);
    addWidget(cancel_);
    addPermanentWidget(frame_);
    addPermanentWidget(device_);
    connect(cancel_, &QPushButton::clicked, this, &StatusLine::cancelRequested);
    hideProgress();
}

void StatusLine::showReadout(const QString& text) { readout_->setText(text); }

void StatusLine::showDevice(const QString& name) {
    device_->setText(fontMetrics().elidedText(name, Qt::ElideRight, 260));
    device_->setToolTip(name);
}

void StatusLine::showFrame(const FrameFacts& facts, std::size_t volume_bytes) {
    const double mib = double(facts.bytes_held + volume_bytes) / (1024.0 * 1024.0);
    frame_->setText(tr("%1 · %2 ms%3 · %4 MiB")
                        .arg(facts.plan)
                        .arg(facts.ms, 0, 'f', facts.ms < 10 ? 1 : 0)
                        .arg(facts.coarse ? tr(" (coarse)") : QString())
                        .arg(mib, 0, 'f', mib < 10 ? 1 : 0));
    showDevice(facts.device);
}

void StatusLine::showProgress(const QString& what, double share) {
    what_->setText(what);
    bar_->setRange(0, share < 0 ? 0 : 1000);
    if (share >= 0) bar_->setValue(int(1000 * std::clamp(share, 0.0, 1.0)));
    what_->show();
    bar_->show();
    cancel_->show();
}

void StatusLine::hideProgress() {
    what_->hide();
    bar_->hide();
    cancel_->hide();
}

}  // namespace lacuna::ui
