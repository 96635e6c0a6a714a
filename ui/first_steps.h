// The steps of a first job in a row above the view: which are done, which comes next and how. They tick
// themselves off as the user takes them, by whatever way.
#pragma once

#include <QFrame>
#include <QString>

#include <array>
#include <string>

class QLabel;
class QToolButton;

namespace facetmill {
struct Project;
}

namespace facetmill::ui {

class MainWindow;

class FirstSteps : public QFrame {
    Q_OBJECT
public:
    enum class Step { open, place, operations, judge, write };
    static constexpr std::size_t step_count = 5;

    /// Above the window's view; hidden until `start`.
    explicit FirstSteps(MainWindow& window);

    /// From the beginning, of the project that is open.
    void start();
    /// A step is done, or one after it, which means that it was not needed.
    bool done(Step step) const;
    /// The first that is not done; step_count where all are.
    std::size_t next() const;
    QToolButton* button(Step step) const { return buttons_[std::size_t(step)]; }

protected:
    void changeEvent(QEvent* event) override;

private:
    void take(Step step);
    /// What the project says of steps that leave their mark in it.
    void look();
    void reset();
    void show_steps();
    static std::string place_of(const Project& project);
    static std::string operations_of(const Project& project);

    MainWindow& window_;
    std::array<QToolButton*, step_count> buttons_{};
    QLabel* how_ = nullptr;
    std::array<bool, step_count> taken_{};
    std::string place_before_, operations_before_; ///< as the project was opened
};

} // namespace facetmill::ui
