#include "ui/playback_bar.h"

#include "ui/icon_button.h"
#include "ui/text.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QResizeEvent>
#include <QSignalBlocker>
#include <QSlider>
#include <QSpinBox>
#include <QToolButton>

#include <algorithm>
#include <cmath>
#include <limits>

namespace facetmill::ui {

namespace {

constexpr int narrow_bar = 820;
constexpr double time_speeds[] = {1, 2, 5, 10, 20, 50, 100, 200, 500, 1000};
constexpr double motion_speeds[] = {1, 10, 100, 1000, 10000};

/// "0:07", "12:40", "3:05:00": steadier while it runs than words are.
QString clock_text(double seconds) {
    const auto s = qint64(std::max(0.0, seconds));
    const QString tail = QStringLiteral("%1:%2")
                             .arg(s / 60 % 60, s >= 3600 ? 2 : 1, 10, QChar('0'))
                             .arg(s % 60, 2, 10, QChar('0'));
    return s >= 3600 ? QStringLiteral("%1:%2").arg(s / 3600).arg(tail) : tail;
}

} // namespace

PlaybackBar::PlaybackBar(PlaybackController& playback, QWidget* parent)
    : QWidget(parent), playback_(playback) {
    setObjectName(QStringLiteral("playback_bar"));
    rows_ = new QBoxLayout(QBoxLayout::LeftToRight, this);
    rows_->setContentsMargins(8, 2, 8, 2);
    rows_->setSpacing(4);
    rows_->setSizeConstraint(QLayout::SetNoConstraint); // the window may be narrower than all of it
    setMinimumWidth(160);
    auto* first = new QHBoxLayout;
    auto* second = new QHBoxLayout;
    for (auto* row : {first, second})
        row->setSpacing(4);
    rows_->addLayout(first, 1);
    rows_->addLayout(second, 0);
    add_drive(*first);
    add_fields(*second);
    connect(&playback_, &PlaybackController::loaded_changed, this, &PlaybackBar::reload);
    connect(&playback_, &PlaybackController::moved, this, &PlaybackBar::show_position);
    connect(&playback_, &PlaybackController::playing_changed, this, [this] {
        play_->setIcon(icon(playback_.playing() ? Icon::pause : Icon::play));
        play_->setToolTip(playback_.playing() ? tr("Pause (Space)") : tr("Play (Space)"));
    });
    reload();
}

void PlaybackBar::add_drive(QBoxLayout& row) {
    const auto add_button = [&](Icon which, const QString& tip, const char* name, auto run) {
        auto* b = icon_button(this, which, tip, name, 18); // after a click the space bar still plays
        connect(b, &QToolButton::clicked, this, run);
        row.addWidget(b);
        return b;
    };
    add_button(Icon::to_start, tr("To the start"), "play_start", [this] {
        playback_.pause();
        playback_.go_to(0);
    });
    add_button(Icon::step_back, tr("One motion back (,)"), "play_back", [this] { playback_.step(-1); });
    play_ = add_button(Icon::play, tr("Play (Space)"), "play", [this] { playback_.toggle(); });
    add_button(Icon::step_forward, tr("One motion on (.)"), "play_forward", [this] { playback_.step(1); });
    add_button(Icon::to_end, tr("To the end"), "play_end", [this] {
        playback_.pause();
        playback_.go_to(double(playback_.track().motion_count()));
    });
    slider_ = new QSlider(Qt::Horizontal, this);
    slider_->setObjectName(QStringLiteral("play_slider"));
    slider_->setMinimumWidth(80);
    slider_->setAccessibleName(tr("Motion"));
    slider_->setFocusPolicy(Qt::TabFocus);
    slider_->setToolTip(tr("All motions of all operations"));
    connect(slider_, &QSlider::valueChanged, this, [this](int value) { playback_.go_to(double(value)); });
    connect(slider_, &QSlider::sliderPressed, &playback_, &PlaybackController::pause);
    row.addWidget(slider_, 1);
}

void PlaybackBar::add_fields(QBoxLayout& row) {
    operation_ = new QComboBox(this);
    operation_->setObjectName(QStringLiteral("play_operation"));
    operation_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    operation_->setMinimumWidth(85);
    operation_->setMaximumWidth(400);
    operation_->setFocusPolicy(Qt::TabFocus);
    connect(operation_, &QComboBox::activated, this, [this](int i) {
        playback_.pause();
        if (playback_.loaded() && i >= 0 && std::size_t(i) < playback_.track().operation_count())
            playback_.go_to(MotionPlace{std::size_t(i), 0});
    });
    goto_ = new QSpinBox(this);
    goto_->setObjectName(QStringLiteral("play_goto"));
    goto_->setKeyboardTracking(false);
    goto_->setPrefix(tr("GOTO "));
    goto_->setFocusPolicy(Qt::StrongFocus);
    goto_->setToolTip(tr("Number of the GOTO in the operation's program"));
    goto_->setAccessibleName(goto_->toolTip());
    connect(goto_, &QSpinBox::valueChanged, this, [this](int n) {
        if (!playback_.loaded()) return;
        playback_.pause();
        playback_.go_to(MotionPlace{playback_.track().place(playback_.target()).program, std::size_t(n - 1)});
    });
    of_ = new QLabel(this);
    of_->setObjectName(QStringLiteral("play_of"));
    time_ = new QLabel(this);
    time_->setObjectName(QStringLiteral("play_time"));
    time_->setToolTip(tr("Machining time until here, and of all operations"));
    time_->setAlignment(Qt::AlignCenter);
    speed_ = new QComboBox(this);
    speed_->setObjectName(QStringLiteral("play_speed"));
    speed_->setToolTip(tr("Times as fast as the machine, or motions per second"));
    speed_->setFocusPolicy(Qt::TabFocus);
    for (const double s : time_speeds)
        speed_->addItem(QStringLiteral("× %1").arg(s), s);
    speed_->insertSeparator(speed_->count());
    for (const double s : motion_speeds)
        speed_->addItem(tr("%1 GOTO/s").arg(count_text(std::size_t(s))), -s);
    speed_->setMaxVisibleItems(20);
    speed_->setMinimumWidth(80); // beside hours in a small window, which are to be read whole
    connect(speed_, &QComboBox::currentIndexChanged, this, &PlaybackBar::take_speed);
    speed_->setCurrentIndex(4);
    turn_ = new QToolButton(this);
    turn_->setObjectName(QStringLiteral("play_turn"));
    turn_->setText(tr("Turn part"));
    turn_->setToolTip(tr("See the part turn under a standing tool, as on the machine"));
    turn_->setCheckable(true);
    turn_->setAutoRaise(true);
    turn_->setFocusPolicy(Qt::TabFocus);
    row.addWidget(turn_);
    for (QWidget* w : std::initializer_list<QWidget*>{operation_, goto_, of_})
        row.addWidget(w);
    row.addStretch(1);
    row.addWidget(time_);
    row.addWidget(speed_);
}

QToolButton* PlaybackBar::button(const char* name) const {
    return findChild<QToolButton*>(QLatin1String(name));
}

bool PlaybackBar::turns_part() const {
    return turn_->isChecked();
}

QString PlaybackBar::time_text() const {
    return time_->text();
}

void PlaybackBar::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    rows_->setDirection(event->size().width() < narrow_bar ? QBoxLayout::TopToBottom
                                                           : QBoxLayout::LeftToRight);
}

void PlaybackBar::take_speed() {
    const double value = speed_->currentData().toDouble();
    using Unit = PlaybackSpeed::Unit;
    playback_.set_speed(value < 0 ? PlaybackSpeed{Unit::motions_per_second, -value}
                                  : PlaybackSpeed{Unit::machining_time, value});
}

void PlaybackBar::reload() {
    const bool on = playback_.loaded();
    setEnabled(on);
    const QSignalBlocker block_slider(slider_), block_operation(operation_), block_goto(goto_);
    operation_->clear();
    slider_->setRange(0, 0);
    bool turns = false;
    if (on) {
        const PlaybackTrack& track = playback_.track();
        for (std::size_t i = 0; i < track.operation_count(); ++i) {
            operation_->addItem(elided(text(track.operation(i).name), 60));
            turns = turns || track.operation(i).turning;
        }
        constexpr auto most = std::size_t(std::numeric_limits<int>::max());
        slider_->setRange(0, int(std::min(track.motion_count(), most)));
        slider_->setPageStep(std::max(1, slider_->maximum() / 50));
    }
    turn_->setVisible(turns);
    show_position();
}

void PlaybackBar::show_position() {
    if (!playback_.loaded()) {
        of_->setText({});
        time_->setText({});
        return;
    }
    const PlaybackTrack& track = playback_.track();
    const MotionPlace at = track.place(playback_.target());
    const QSignalBlocker block_slider(slider_), block_operation(operation_), block_goto(goto_);
    // While it is held the user's hand is where it is.
    if (!slider_->isSliderDown()) slider_->setValue(int(playback_.target()));
    operation_->setCurrentIndex(int(at.program));
    operation_->setToolTip(text(track.operation(at.program).name));
    goto_->setRange(1, int(track.motions_of(at.program)));
    goto_->setValue(int(at.motion + 1));
    of_->setText(tr("of %1").arg(count_text(track.motions_of(at.program))));
    const QString total = clock_text(track.seconds());
    // As wide as it can become, and no wider: in a small window there is no room to spare.
    QString longest = QStringLiteral("%1 / %1").arg(total);
    for (QChar& c : longest)
        if (c.isDigit()) c = QChar('0');
    time_->setMinimumWidth(time_->fontMetrics().horizontalAdvance(longest) + 2);
    time_->setText(QStringLiteral("%1 / %2").arg(clock_text(track.time_at(playback_.target())), total));
    // What is cut lags behind: said where one looks for how far it is.
    time_->setEnabled(!playback_.behind() || playback_.playing());
}

} // namespace facetmill::ui
