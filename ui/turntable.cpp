#include "ui/turntable.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <memory>
#include <vector>

#include "core/base/atomic_file.h"
#include "core/io/image_writer.h"
#include "core/render/turn.h"

namespace lacuna::ui {

namespace {

QString words_of(const char* text) { return QCoreApplication::translate("Turntable", text); }

/// STEM-000.png and so on, with as many digits as the last one needs.
QString frame_name(const QString& stem, int number, int frames) {
    const int digits = std::max(3, int(QString::number(frames - 1).size()));
    return QStringLiteral("%1-%2.png").arg(stem).arg(number, digits, 10, QLatin1Char('0'));
}

Plan plan_of_turn(const Turntable& table, const std::vector<Camera>& views, Engine& engine, const JobContext& job) {
    if (!table.budget) return table.plan;
    Budget budget = *table.budget;
    budget.frames = std::max(budget.frames, table.frames);
    budget.other_views.assign(views.begin() + 1, views.end());
    budget.costs = costs_of(engine, job.part(0, 0.1));
    return choose_plan(engine, table.scene, budget, job.part(0.1, 1)).plan;
}

/// All the pictures appear at the end, or none.
void draw_frames(const Turntable& table, const QString& stem, Engine& engine, const JobContext& job) {
    const std::vector<Camera> views = full_turn(table.scene.camera, table.frames);
    const Plan plan = plan_of_turn(table, views, engine, job.part(0, 0.1));
    const JobContext drawing = job.part(0.1, 1);
    Scene scene = table.scene;
    std::vector<std::unique_ptr<AtomicFile>> files;
    for (int i = 0; i < table.frames; ++i) {
        scene.camera = views[std::size_t(i)];
        const Frame frame = engine.render(scene, plan, {job.stop, nullptr}).frame;
        files.push_back(std::make_unique<AtomicFile>(frame_name(stem, i, table.frames).toStdString()));
        write_png(files.back()->path(), frame.size, to_rgb8(frame, glm::dvec3(0)));
        drawing.checkpoint(std::size_t(i) + 1, std::size_t(table.frames));
    }
    for (const auto& file : files) file->commit();
}

/// The pictures' pattern is put together by hand: QString::arg would take ffmpeg's %0 for its own.
void encode_film(const Turntable& table, const QString& stem, const QString& target, const JobContext& job) {
    const int digits = std::max(3, int(QString::number(table.frames - 1).size()));
    QStringList words{QStringLiteral("-y"),
                      QStringLiteral("-loglevel"),
                      QStringLiteral("error"),
                      QStringLiteral("-framerate"),
                      QStringLiteral("24"),
                      QStringLiteral("-i"),
                      stem + QStringLiteral("-%0") + QString::number(digits) + QStringLiteral("d.png")};
    const bool webm = table.file.endsWith(QStringLiteral(".webm"), Qt::CaseInsensitive);
    words << QStringLiteral("-c:v") << (webm ? QStringLiteral("libvpx-vp9") : QStringLiteral("libx264"))
          << QStringLiteral("-pix_fmt") << QStringLiteral("yuv420p") << target;
    QProcess ffmpeg;
    ffmpeg.start(film_encoder(), words);
    while (!ffmpeg.waitForFinished(30)) {
        if (ffmpeg.state() == QProcess::NotRunning) break;
        if (!job.stopped()) continue;
        ffmpeg.kill();
        ffmpeg.waitForFinished();
        job.check();
    }
    if (ffmpeg.exitStatus() != QProcess::NormalExit || ffmpeg.exitCode() != 0)
        throw Error(Errc::unsupported, words_of(QT_TRANSLATE_NOOP("Turntable", "ffmpeg could not make the film: %1"))
                                           .arg(QString::fromLocal8Bit(ffmpeg.readAllStandardError()).trimmed())
                                           .toStdString());
}

}  // namespace

QString film_encoder() { return QStandardPaths::findExecutable(QStringLiteral("ffmpeg")); }

void write_turntable(const Turntable& table, Engine& engine, const JobContext& job) {
    const QFileInfo info(table.file);
    if (info.suffix().compare(QStringLiteral("png"), Qt::CaseInsensitive) == 0)
        return draw_frames(table, info.path() + QLatin1Char('/') + info.completeBaseName(), engine, job);
    if (film_encoder().isEmpty())
        throw Error(Errc::unsupported, words_of(QT_TRANSLATE_NOOP("Turntable",
                                                                  "A film needs the program ffmpeg, which is not "
                                                                  "there; save pictures (.png)."))
                                           .toStdString());
    QTemporaryDir folder;
    if (!folder.isValid())
        throw Error(Errc::io, words_of(QT_TRANSLATE_NOOP("Turntable", "There is no place for the film's pictures: %1."))
                                  .arg(folder.errorString())
                                  .toStdString());
    const QString stem = folder.filePath(QStringLiteral("frame"));
    draw_frames(table, stem, engine, job.part(0, 0.9));
    AtomicFile target(table.file.toStdString());
    encode_film(table, stem, QString::fromStdString(target.path().string()), job);
    target.commit();
}

}  // namespace lacuna::ui
