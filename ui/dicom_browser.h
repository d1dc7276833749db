#pragma once

#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSortFilterProxyModel>
#include <QStandardItemModel>
#include <QTreeView>

#include "core/io/dicom_catalogue.h"
#include "ui/task.h"

namespace lacuna::ui {

/// What a folder or a DICOMDIR holds, by patients, studies and series with small pictures: found in the background
/// while one already looks, searched as one types, opened by a double click.
class DicomBrowser final : public QDialog {
    Q_OBJECT
public:
    explicit DicomBrowser(TaskList* tasks, QWidget* parent = nullptr);
    ~DicomBrowser() override;

    /// Looks through a folder or reads a DICOMDIR; one that is under way is given up.
    void look(const QString& input);
    const Catalogue& catalogue() const { return catalogue_; }
    QTreeView* tree() const { return tree_; }
    QLineEdit* searchBox() const { return search_; }
    QLabel* statusText() const { return status_; }
    int seriesShown() const;

Q_SIGNALS:
    void openRequested(const QString& folder, const QString& uid);
    void looked();    ///< the search has ended
    void pictured();  ///< all small pictures are there

private:
    void chooseFolder();
    void chooseDicomdir();
    void showCatalogue(const Catalogue& catalogue);
    void addPictures();
    void activate(const QModelIndex& index);
    void openCurrent();
    void say(const Catalogue& catalogue, bool done);

    Catalogue catalogue_;
    QLineEdit* path_;
    QLineEdit* search_;
    QTreeView* tree_;
    QLabel* status_;
    QPushButton* open_;
    QStandardItemModel* model_;
    std::vector<QStandardItem*> series_items_;  ///< of the model, in the catalogue's order
    QSortFilterProxyModel* filter_;
    Task<Catalogue> scan_;
    LatestJob<int> pictures_;
};

}  // namespace lacuna::ui
