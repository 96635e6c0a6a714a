#include "ui/start_hint.h"

#include "core/mesh/mesh_format.h"
#include "core/mesh/sample.h"
#include "ui/icons.h"
#include "ui/recent_pictures.h"
#include "ui/text.h"
#include "ui/theme.h"
#include "ui/usual_project_box.h"
#include "ui/viewport.h"
#include "ui/worded.h"

#include <QEvent>
#include <QFileInfo>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QScrollBar>
#include <QVBoxLayout>

namespace facetmill::ui {

namespace {

/// Points of the view that lists of pictures need.
constexpr int room_width = 520, room_height = 480;
/// Pictures in a row before the list scrolls, or goes on below.
constexpr int min_in_a_row = 4, max_in_a_row = 6;
constexpr int gap = 8, side_margin = 22;

QLabel* heading(const QString& words, QWidget* parent) {
    auto* label = new QLabel(words, parent);
    QFont bold = label->font();
    bold.setBold(true);
    label->setFont(bold);
    return label;
}

} // namespace

StartHint::StartHint(QMenu* samples, QWidget* parent) : QFrame(parent) {
    setObjectName(QStringLiteral("start_hint"));
    setAutoFillBackground(true);
    setFrameShape(QFrame::StyledPanel);
    title_ = new QLabel(tr("Open a mesh or drop one here"), this);
    QFont large = title_->font();
    large.setPointSizeF(large.pointSizeF() * 1.3);
    large.setBold(true);
    title_->setFont(large);
    title_->setAlignment(Qt::AlignCenter);
    text_ = new QLabel(tr("%1, or a Facetmill project").arg(text(mesh_format_names())), this);
    text_->setAlignment(Qt::AlignCenter);
    text_->setWordWrap(true);
    text_->setForegroundRole(QPalette::PlaceholderText);
    auto* open = new QPushButton(icon(Icon::open), tr("Open…"), this);
    open->setObjectName(QStringLiteral("hint_open"));
    connect(open, &QPushButton::clicked, this, &StartHint::open_requested);
    auto* sample = new QPushButton(icon(Icon::part), tr("New from sample"), this);
    sample->setObjectName(QStringLiteral("hint_sample"));
    sample->setMenu(samples);
    auto* buttons = new QHBoxLayout;
    buttons->addStretch(1);
    buttons->addWidget(open);
    buttons->addWidget(sample);
    buttons->addStretch(1);

    more_ = new QWidget(this);
    auto* lists = new QVBoxLayout(more_);
    lists->setContentsMargins(0, 6, 0, 0);
    recent_label_ = heading(tr("Recent"), more_);
    recent_ = make_list(QStringLiteral("recent_list"), tr("Recent files"));
    connect(recent_, &QListWidget::itemActivated, this,
            [this](const QListWidgetItem* item) { emit file_chosen(item->data(Qt::UserRole).toString()); });
    samples_ = make_list(QStringLiteral("sample_list"), tr("Samples"));
    connect(samples_, &QListWidget::itemActivated, this, [this](const QListWidgetItem* item) {
        emit sample_chosen(utf8(item->data(Qt::UserRole).toString()));
    });
    list_samples();
    usual_ = new UsualProjectBox(more_);
    connect(usual_, &UsualProjectBox::chosen, this, [this] { settings::set_usual_project(usual_->usual()); });
    lists->addWidget(recent_label_);
    lists->addWidget(recent_);
    lists->addWidget(heading(tr("Samples"), more_));
    lists->addWidget(samples_);
    lists->addWidget(heading(tr("New projects are for"), more_));
    lists->addWidget(usual_);

    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(side_margin, 18, side_margin, 18);
    column->setSpacing(10);
    column->addWidget(title_);
    column->addWidget(text_);
    column->addLayout(buttons);
    column->addWidget(more_);
    parent->installEventFilter(this);
    place();
}

QListWidget* StartHint::make_list(const QString& name, const QString& called) {
    auto* list = new QListWidget(more_);
    list->setObjectName(name);
    list->setAccessibleName(called);
    list->setViewMode(QListView::IconMode);
    list->setFlow(QListView::LeftToRight);
    list->setWrapping(false);
    list->setMovement(QListView::Static);
    list->setIconSize(QSize(recent_picture_width, recent_picture_height) * 3 / 4);
    list->setFrameShape(QFrame::NoFrame);
    list->viewport()->setAutoFillBackground(false);
    list->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    const QSize cell = list->iconSize() + QSize(2 * gap, list->fontMetrics().height() + 2 * gap);
    list->setGridSize(cell);
    return list;
}

/// All pictures where they fit, in rows of so many; else one row that scrolls.
void StartHint::lay_out(QListWidget& list, int in_a_row, int spare_height) {
    const QSize cell = list.gridSize();
    const int rows = std::max(1, (list.count() + in_a_row - 1) / in_a_row);
    const bool all = (rows - 1) * cell.height() <= spare_height;
    const int bar = list.horizontalScrollBar()->sizeHint().height();
    list.setWrapping(all);
    list.setFixedSize(in_a_row * cell.width() + 4, all ? rows * cell.height() + 2 : cell.height() + bar + 2);
}

QString StartHint::short_name(const QString& name) const {
    return fontMetrics().elidedText(name, Qt::ElideMiddle, recent_->gridSize().width() - gap);
}

void StartHint::list_recent() {
    recent_->clear();
    for (const QString& path : settings::recent_files()) {
        const QFileInfo file(path);
        const QPixmap picture = recent_picture(path);
        auto* item = new QListWidgetItem(picture.isNull() ? icon(Icon::part) : QIcon(picture),
                                         short_name(file.fileName()), recent_);
        item->setToolTip(path);
        item->setData(Qt::UserRole, path);
        if (!file.exists()) item->setFlags(Qt::NoItemFlags);
    }
    recent_->setVisible(recent_->count() > 0);
    recent_label_->setVisible(recent_->count() > 0);
}

/// Names that are longer than their pictures are wide have two lines; the lists of recent files end theirs
/// with dots, as they can be of any length.
void StartHint::list_samples() {
    samples_->setWordWrap(true);
    QSize cell = samples_->gridSize();
    for (const SampleKind& kind : sample_kinds()) {
        const QIcon picture(QStringLiteral(":/pictures/samples/%1.png").arg(text(kind.name)));
        const QString name = worded(kind.label);
        if (short_name(name) != name)
            cell.setHeight(recent_->gridSize().height() + samples_->fontMetrics().lineSpacing());
        auto* item = new QListWidgetItem(picture, name, samples_);
        item->setToolTip(worded(kind.help));
        item->setData(Qt::UserRole, text(kind.name));
    }
    samples_->setGridSize(cell);
}

void StartHint::show_usual() {
    usual_->set_usual(settings::usual_project());
}

void StartHint::place() {
    if (!parentWidget()) return;
    const QSize room = parentWidget()->size();
    more_->setVisible(room.width() >= room_width && room.height() >= room_height);
    const int columns = std::clamp((room.width() - 2 * side_margin - 40) / samples_->gridSize().width(),
                                   min_in_a_row, max_in_a_row);
    lay_out(*recent_, columns, 0);
    lay_out(*samples_, columns, room.height() - room_height);
    more_->updateGeometry(); // what follows asks how large it is now
    adjustSize();
    move(std::max(0, (room.width() - width()) / 2), std::max(0, (room.height() - height()) / 2));
}

bool StartHint::eventFilter(QObject* object, QEvent* event) {
    if (event->type() == QEvent::Resize || event->type() == QEvent::Show) place();
    return QFrame::eventFilter(object, event);
}

void StartHint::showEvent(QShowEvent* event) {
    list_recent();
    place();
    show_axes(false);
    QFrame::showEvent(event);
}

void StartHint::hideEvent(QHideEvent* event) {
    show_axes(true);
    QFrame::hideEvent(event);
}

/// Axes of nothing would look out from behind the page.
void StartHint::show_axes(bool on) {
    auto* view = qobject_cast<Viewport*>(parentWidget());
    if (!view || view->scene().visible(Layer::axes) == on) return;
    view->scene().set_visible(Layer::axes, on);
    view->content_changed();
}

} // namespace facetmill::ui
