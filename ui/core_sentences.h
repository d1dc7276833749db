#pragma once

#include <QString>
#include <QStringList>
#include <string>

namespace lacuna::ui {

/// A sentence of the core (an error's, a warning's, a reason's) in the language of the window; one that is not known,
/// and every one in English, as it is. The core speaks English; what is known here are its own words, with %1, %2 ..
/// for what it fills in. Numbers filled in get the language's decimal mark. Cost: about 50 us the first time.
QString core_sentence(const QString& english);
QString core_sentence(const std::string& english);
QString core_sentence(const char* english);

/// The sentences known, in English.
QStringList core_sentences();
/// The parts of sentences known, in English.
QStringList core_phrases();

}  // namespace lacuna::ui
