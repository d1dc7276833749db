#include "ui/file_writes.h"

namespace lacuna::ui {

void FileWrites::start(const QString& name, const QString& file, Work work, const QString& done,
                       const MessageBar::Answers& answers) {
    jobs_.start(
        name,
        [work = std::move(work), file](const JobContext& job) {
            work(job);
            return file;
        },
        [this, answers, sentence = done.isEmpty() ? tr("Written to %1.") : done](Outcome<QString> outcome) {
            if (const Error* error = std::get_if<Error>(&outcome)) return bench_.report(*error);
            const QString words = sentence.arg(std::get<0>(outcome));
            answers.isEmpty() ? bench_.messages()->showNotice(words) : bench_.messages()->ask(words, answers);
            Q_EMIT written(std::get<0>(outcome));
        });
}

}  // namespace lacuna::ui
