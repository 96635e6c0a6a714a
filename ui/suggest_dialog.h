// The page of suggestions: at most three operations, each with its picture, what it takes and leaves, and
// why. It shows and asks; suggest_controller.h looks for them.
#pragma once

#include <QDialog>
#include <QIcon>
#include <QStringList>

#include <vector>

class QLabel;
class QProgressBar;
class QPushButton;
class QVBoxLayout;

namespace facetmill::ui {

class SuggestDialog : public QDialog {
    Q_OBJECT
public:
    struct Card {
        QIcon picture;
        QString title, figures; ///< "Waterline, T1 Ball 6 mm"; "4 min 10 s; ..."
        QStringList reasons;
    };
    explicit SuggestDialog(QWidget* parent = nullptr);

    /// What stands above the cards.
    void show_status(const QString& words);
    QString status() const;
    /// Below 0: nothing runs.
    void show_progress(double share);
    void show_cards(const std::vector<Card>& cards);
    QPushButton* again_button() { return again_; }
    QPushButton* stop_button() { return stop_; }
    /// That adds the operation of a card.
    QPushButton* add_button(std::size_t card) const { return adds_.at(card); }
    std::size_t card_count() const { return adds_.size(); }
    QSize sizeHint() const override { return {620, 520}; }

signals:
    void again_wanted();
    void stop_wanted();
    void add_wanted(std::size_t card);

private:
    QLabel* status_ = nullptr;
    QProgressBar* progress_ = nullptr;
    QWidget* list_ = nullptr;
    QVBoxLayout* column_ = nullptr;
    QPushButton *again_ = nullptr, *stop_ = nullptr;
    std::vector<QPushButton*> adds_;
};

} // namespace facetmill::ui
