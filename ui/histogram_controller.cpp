#include "ui/histogram_controller.h"

namespace lacuna::ui {

namespace {
constexpr int k_still_ms = 150;
}

HistogramController::HistogramController(QObject* parent) : QObject(parent), job_(this), joint_job_(this) {
    still_.setSingleShot(true);
    still_.setInterval(k_still_ms);
    connect(&still_, &QTimer::timeout, this, [this] {
        count();
        countJoint();
    });
}

void HistogramController::setVolume(const Volume& volume, std::shared_ptr<const VolumeStatistics> statistics) {
    still_.stop();
    job_.cancel();
    joint_job_.cancel();
    volume_ = volume;
    statistics_ = std::move(statistics);
    part_ = {};
    joint_part_.reset();
    Q_EMIT counted(statistics_->histogram);
    countJoint();
}

void HistogramController::setPart(const VolumePart& part) {
    if (!statistics_ || part == part_) return;
    part_ = part;
    still_.start();
}

void HistogramController::setJointWanted(bool wanted) {
    joint_wanted_ = wanted;
    if (!still_.isActive()) countJoint();
}

void HistogramController::count() {
    job_.start([volume = volume_, statistics = statistics_,
                part = part_](const JobContext& job) { return part_histogram(volume, *statistics, part, job); },
               [this](Outcome<std::vector<std::uint64_t>> outcome) {
                   if (const Error* error = std::get_if<Error>(&outcome))
                       Q_EMIT failed(QString::fromStdString(error->what()));
                   else
                       Q_EMIT counted(std::get<0>(outcome));
               });
}

void HistogramController::countJoint() {
    if (!joint_wanted_ || !statistics_ || joint_part_ == part_) return;
    joint_part_ = part_;
    joint_job_.start(
        [volume = volume_, statistics = statistics_, part = part_](const JobContext& job) {
            return std::make_shared<const JointHistogram>(joint_histogram(volume, *statistics, part, job));
        },
        [this](Outcome<std::shared_ptr<const JointHistogram>> outcome) {
            if (const Error* error = std::get_if<Error>(&outcome)) {
                joint_part_.reset();
                Q_EMIT failed(QString::fromStdString(error->what()));
            } else {
                Q_EMIT jointCounted(std::get<0>(outcome));
            }
        });
}

}  // namespace lacuna::ui
