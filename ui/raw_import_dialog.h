#pragma once

#include <QComboBox>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QImage>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSlider>
#include <QSpinBox>
#include <array>

#include "core/io/raw_guess.h"
#include "ui/latest_job.h"

class QFormLayout;

namespace lacuna::ui {

/// A picture that keeps its shape while it fills its widget.
class PicturePreview final : public QWidget {
    Q_OBJECT
public:
    explicit PicturePreview(QWidget* parent = nullptr);
    void setImage(const QImage& image, double pixel_aspect = 1);
    const QImage& image() const { return image_; }
    QSize sizeHint() const override { return {380, 380}; }

protected:
    void paintEvent(QPaintEvent*) override;

private:
    QImage image_;
    double aspect_ = 1;  ///< height of a pixel over its width
};

/// Asks how a raw file is to be read: proposes layouts with how sure they are, and shows the slice that the numbers
/// entered make of the file at once. The file is read on a worker thread.
class RawImportDialog final : public QDialog {
    Q_OBJECT
public:
    explicit RawImportDialog(const QString& file, QWidget* parent = nullptr);

    RawLayout layout() const;
    void setLayoutValues(const RawLayout& layout);
    const std::vector<RawGuess>& proposals() const { return guesses_; }
    QListWidget* proposalList() const { return list_; }
    PicturePreview* preview() const { return preview_; }
    QSlider* sliceSlider() const { return slice_; }
    QLabel* sizeLine() const { return size_line_; }
    QPushButton* openButton() const { return open_; }

Q_SIGNALS:
    void proposed();                  ///< the proposals are there
    void previewed();                 ///< the picture shows the numbers as they are
    void chosen(const QString& raw);  ///< the layout as the words of --raw

private:
    QWidget* makeForm();
    void addSpacing(QFormLayout* form);
    /// The buttons that fill in what follows from the file's size.
    void addHelp(QFormLayout* form);
    QWidget* makePreview();
    void propose();
    void showProposals(const std::vector<RawGuess>& guesses);
    void edited();
    void fitDepth();
    void restIsHeader();
    void showSize();
    void drawSlice();
    std::uint64_t needed() const;

    std::filesystem::path file_;
    std::uint64_t bytes_ = 0;
    std::vector<RawGuess> guesses_;
    QListWidget* list_;
    std::array<QSpinBox*, 3> size_{};
    QComboBox* type_;
    QComboBox* order_;
    QSpinBox* header_;
    std::array<QDoubleSpinBox*, 3> spacing_{};
    QLabel* size_line_;
    PicturePreview* preview_;
    QSlider* slice_;
    QLabel* slice_text_;
    QPushButton* open_ = nullptr;
    bool touched_ = false;  ///< a person changed numbers: proposals that come later do not replace them
    bool silent_ = false;
    LatestJob<std::vector<RawGuess>> guess_job_;
    LatestJob<QImage> preview_job_;
};

}  // namespace lacuna::ui
