#include "ui/strip_panel.h"

#include "ui/elided_label.h"
#include "ui/icons.h"
#include "ui/sorted_item.h"
#include "ui/text.h"
#include "ui/worded.h"
#include "viz/strip_display.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QStackedWidget>
#include <QStyle>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace facetmill::ui {

namespace {

constexpr int strip_role = Qt::UserRole;

QString type_text(const Strip& strip) {
    switch (strip.kind) {
    case StripKind::rework:
        return StripPanel::tr("Rework");
    case StripKind::sharp:
        return StripPanel::tr("Normal change");
    case StripKind::valley:
        return strip.centers.empty() ? StripPanel::tr("Hollow") : StripPanel::tr("Two contacts");
    case StripKind::no_posture:
        return StripPanel::tr("No posture");
    case StripKind::rest:
        return StripPanel::tr("Rest material");
    case StripKind::foot:
        return StripPanel::tr("Foot of a wall");
    }
    return {};
}

} // namespace

StripPanel::StripPanel(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("strips"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(6, 4, 6, 6);
    column->setSpacing(4);
    pages_ = new QStackedWidget(this);
    column->addWidget(pages_);
    empty_ = new QLabel(pages_);
    empty_->setObjectName(QStringLiteral("strips_empty"));
    empty_->setWordWrap(true);
    empty_->setAlignment(Qt::AlignCenter);
    empty_->setMargin(12);
    empty_->setTextFormat(Qt::PlainText);
    empty_->setForegroundRole(QPalette::PlaceholderText);
    empty_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    pages_->addWidget(empty_);

    auto* page = new QWidget(pages_);
    pages_->addWidget(page);
    column = new QVBoxLayout(page);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    operation_ = new QComboBox(page);
    operation_->setObjectName(QStringLiteral("strips_operation"));
    operation_->setToolTip(tr("Of which operation"));
    operation_->setFocusPolicy(Qt::TabFocus);
    operation_->setMinimumContentsLength(8);
    column->addWidget(operation_);
    note_ = new ElidedLabel(page);
    note_->setObjectName(QStringLiteral("strips_note"));
    column->addWidget(note_);
    list_ = new QTreeWidget(page);
    list_->setObjectName(QStringLiteral("strip_list"));
    list_->setHeaderLabels({tr("Strip"), tr("Type"), tr("Width"), tr("Length"), tr("Reason")});
    list_->setToolTip(tr("Click: the view goes there. Check mark: whether the strip is cut."));
    list_->setRootIsDecorated(false);
    list_->setUniformRowHeights(true);
    list_->setSortingEnabled(true);
    list_->setTextElideMode(Qt::ElideRight);
    list_->setIconSize(QSize(swatch_size, swatch_size));
    list_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Expanding);
    list_->header()->setSectionsMovable(false);
    list_->header()->setStretchLastSection(true);
    // Over right-aligned numbers, right-aligned headings.
    for (const Column c : {width_column, length_column})
        list_->headerItem()->setTextAlignment(c, Qt::AlignRight | Qt::AlignVCenter);
    connect(list_->header(), &QHeaderView::sortIndicatorChanged, this, [this] { fit_columns(); });
    column->addWidget(list_, 1);
    touch_ = new QCheckBox(tr("Previous tool at the picked point"), page);
    touch_->setObjectName(QStringLiteral("strip_touch"));
    touch_->setToolTip(tr(
        "Shows the tool that cut before, where it touches the part at two places over the strip and can go "
        "no deeper. Clicks on a strip in the view then mean the strip, not the path on it."));
    touch_->setChecked(true);
    touch_->setFocusPolicy(Qt::TabFocus);
    touch_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    column->addWidget(touch_);
    place_ = new QSlider(Qt::Horizontal, page);
    place_->setObjectName(QStringLiteral("strip_place"));
    place_->setToolTip(tr("Place along the strip; a click on the strip in the view goes there, too"));
    place_->setAccessibleName(tr("Place along the strip"));
    place_->setFocusPolicy(Qt::StrongFocus);
    column->addWidget(place_);
    readout_ = new QLabel(page);
    readout_->setObjectName(QStringLiteral("strip_readout"));
    readout_->setWordWrap(true);
    readout_->setTextFormat(Qt::PlainText);
    readout_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    readout_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Minimum);
    column->addWidget(readout_);
}

void StripPanel::fit_columns() {
    QHeaderView* header = list_->header();
    const QStyle* style = list_->style();
    const int mark = style->pixelMetric(QStyle::PM_HeaderMarkSize, nullptr, header)
                     + style->pixelMetric(QStyle::PM_HeaderMargin, nullptr, header);
    const QAbstractItemView* cells = list_; // the tree hides what the view offers
    for (int c = name_column; c < reason_column; ++c)
        header->resizeSection(
            c, std::max(cells->sizeHintForColumn(c),
                        header->sectionSizeHint(c) - (c == header->sortIndicatorSection() ? 0 : mark)));
}

void StripPanel::fill(const std::vector<Strip>& strips, LengthUnit unit, Palette palette) {
    const QSignalBlocker quiet(list_);
    list_->setSortingEnabled(false);
    list_->clear();
    const double per = mm_per(unit);
    // The same for all, so that points stand one below the other.
    const int decimals = unit == LengthUnit::inch ? 2 : 1;
    for (std::size_t i = 0; i < strips.size(); ++i) {
        const Strip& s = strips[i];
        auto* item = new SortedItem;
        item->setData(name_column, strip_role, qulonglong(i));
        item->setData(name_column, SortedItem::sort_role, double(i));
        item->setText(name_column, text(s.name));
        // It takes its room in the column from the start; the colour comes with the states.
        item->setIcon(name_column, swatch(strip_color(i, true, palette), devicePixelRatioF()));
        item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
        item->setCheckState(name_column, s.enabled ? Qt::Checked : Qt::Unchecked);
        item->setText(type_column, type_text(s));
        const auto number = [&](int column, double mm) {
            item->setText(column, mm > 0 ? in_user_numbers(QString::number(mm / per, 'f', decimals))
                                         : QStringLiteral("–"));
            item->setData(column, SortedItem::sort_role, mm);
            item->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
        };
        number(width_column, s.width);
        number(length_column, s.length);
        const QString reason = with_lengths_in(sentence(worded(s.reason)), unit);
        item->setText(reason_column, reason);
        const QString size =
            s.width > 0
                ? tr("%1 wide, %2 long").arg(shown_length(s.width, unit, 3), shown_length(s.length, unit, 3))
                : tr("%1 long").arg(shown_length(s.length, unit, 3));
        for (int c = name_column; c <= reason_column; ++c)
            item->setToolTip(c, tr("%1: %2. %3").arg(text(s.name), size, reason));
        list_->addTopLevelItem(item);
    }
    const QString unit_text = text(unit_name(unit));
    list_->headerItem()->setText(width_column, tr("Width, %1").arg(unit_text));
    list_->headerItem()->setText(length_column, tr("Length, %1").arg(unit_text));
    list_->setSortingEnabled(true);
    list_->sortByColumn(name_column, Qt::AscendingOrder);
    fit_columns();
}

void StripPanel::show_states(const std::vector<bool>& cut, Palette palette) {
    const QSignalBlocker quiet(list_);
    for (int row = 0; row < list_->topLevelItemCount(); ++row) {
        QTreeWidgetItem* item = list_->topLevelItem(row);
        const std::size_t i = strip_of(*item);
        item->setCheckState(name_column, cut[i] ? Qt::Checked : Qt::Unchecked);
        item->setIcon(name_column, swatch(strip_color(i, cut[i], palette), devicePixelRatioF()));
    }
}

std::size_t StripPanel::strip_of(const QTreeWidgetItem& item) {
    return std::size_t(item.data(name_column, strip_role).toULongLong());
}

QTreeWidgetItem* StripPanel::item_of(std::size_t strip) const {
    for (int row = 0; row < list_->topLevelItemCount(); ++row)
        if (strip_of(*list_->topLevelItem(row)) == strip) return list_->topLevelItem(row);
    return nullptr;
}

void StripPanel::set_empty_text(const QString& text) {
    empty_->setText(kept_together(text));
    pages_->setCurrentIndex(text.isEmpty() ? 1 : 0);
}

QString StripPanel::empty_text() const {
    return empty_->text();
}

} // namespace facetmill::ui
