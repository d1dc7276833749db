#pragma once

#include <QObject>
#include <QString>
#include <vector>

#include "core/io/volume_reader.h"
#include "core/session/document.h"
#include "ui/latest_job.h"

namespace lacuna::ui {

/// Opens inputs on a worker thread. One at a time: a newer one cancels the one before.
class LoadController final : public QObject {
    Q_OBJECT
public:
    explicit LoadController(QObject* parent = nullptr) : QObject(parent), job_(this) {}

    bool loading() const { return job_.running(); }

public Q_SLOTS:
    /// Where several volumes lie under the input and the options name none, the choice is asked for.
    void open(const QString& input, const lacuna::OpenOptions& options = {});
    void cancel();

Q_SIGNALS:
    void started(const QString& input);
    void progressed(double share);
    void loaded(const lacuna::Document& document);
    void failed(const QString& sentence);
    void cancelled();
    /// Several volumes lie under the input; one is to be chosen.
    void choiceNeeded(const QString& input, const std::vector<lacuna::SeriesEntry>& entries);
    /// A raw file of which nothing says how it is to be read.
    void layoutNeeded(const QString& input);
    void finished();  ///< after any of the five outcomes

private:
    /// What a load ends with when it does not fail: a document, the volumes to choose from, or a layout to ask for.
    struct Opened {
        Document document{};
        std::vector<SeriesEntry> choice{};
        bool raw_file = false;
    };
    LatestJob<Opened> job_;
};

}  // namespace lacuna::ui
