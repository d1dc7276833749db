#pragma once

#include <QObject>

#include "core/session/document.h"
#include "ui/latest_job.h"

namespace lacuna::ui {

/// Finds regions, and gathers the voxels of a chosen one, on worker threads.
class RegionController final : public QObject {
    Q_OBJECT
public:
    explicit RegionController(QObject* parent = nullptr) : QObject(parent), find_(this), gather_(this) {}

    bool running() const { return find_.running(); }

public Q_SLOTS:
    void compute(const lacuna::Volume& volume, const lacuna::RegionOptions& options);
    void gather(std::shared_ptr<const lacuna::RegionTable> table, std::uint32_t id);
    void cancel();

Q_SIGNALS:
    void started();
    void progressed(double share);
    void computed(std::shared_ptr<const lacuna::RegionTable> table);
    void gathered(std::uint32_t id, std::shared_ptr<const lacuna::Highlight> highlight);
    void failed(const QString& sentence);
    void finished();

private:
    LatestJob<std::shared_ptr<const RegionTable>> find_;
    LatestJob<std::shared_ptr<const Highlight>> gather_;
};

}  // namespace lacuna::ui
