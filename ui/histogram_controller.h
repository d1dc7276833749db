#pragma once

#include <QObject>
#include <QTimer>
#include <memory>
#include <optional>

#include "core/classify/part_histogram.h"
#include "ui/latest_job.h"

namespace lacuna::ui {

/// Counts the values of a volume or of the part of it that is shown, off the window's thread, and only what is asked
/// for.
class HistogramController final : public QObject {
    Q_OBJECT
public:
    explicit HistogramController(QObject* parent = nullptr);

    /// Forgets what was counted. The whole volume's own histogram is known at once.
    void setVolume(const lacuna::Volume& volume, std::shared_ptr<const lacuna::VolumeStatistics> statistics);
    /// Counts again where the part differs from the last one, once it has stopped changing for a moment.
    void setPart(const lacuna::VolumePart& part);
    /// Whether gradients are wanted too; they cost more.
    void setJointWanted(bool wanted);

Q_SIGNALS:
    void counted(const std::vector<std::uint64_t>& counts);
    void jointCounted(std::shared_ptr<const lacuna::JointHistogram> joint);
    void failed(const QString& sentence);

private:
    void count();
    void countJoint();

    Volume volume_;
    std::shared_ptr<const VolumeStatistics> statistics_;
    VolumePart part_;
    std::optional<VolumePart> joint_part_;  ///< of what was counted last, or is being counted
    bool joint_wanted_ = false;
    QTimer still_;
    LatestJob<std::vector<std::uint64_t>> job_;
    LatestJob<std::shared_ptr<const JointHistogram>> joint_job_;
};

}  // namespace lacuna::ui
