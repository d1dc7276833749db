#include <gtest/gtest.h>

#include <QApplication>

#include "ui/theme.h"

int main(int argc, char** argv) {
    if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
    QApplication application(argc, argv);
    testing::InitGoogleTest(&argc, argv);
    lacuna::ui::apply_theme(application);
    return RUN_ALL_TESTS();
}
