#pragma once

#include <QString>
#include <QStringList>
#include <string>

namespace lacuna::ui {

/// A sentence of the core (an error's, a warning's) in the language of the window, where it is one of the common ones;
/// else, and in English, as it is. The core speaks English; the sentences known here are its own, word by word, with
/// %1, %2 .. for what it fills in. Cost: about 10 us.
QString core_sentence(const QString& english);
QString core_sentence(const std::string& english);
QString core_sentence(const char* english);

/// The sentences known, in English.
QStringList core_sentences();

}  // namespace lacuna::ui
