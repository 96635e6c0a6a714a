#include "ui/study_place.h"

#include "ui/text.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSpinBox>

#include <algorithm>
#include <thread>

namespace facetmill::ui {

namespace {

constexpr int max_at_once = 256;

int processors_here() {
    return int(std::max(1u, std::thread::hardware_concurrency()));
}

} // namespace

StudyPlaceForm::StudyPlaceForm(QWidget* parent) : QWidget(parent) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(6, 2, 6, 4);
    const auto add = [&](const QString& label, QWidget* field, const char* name, int stretch) {
        field->setObjectName(QLatin1String(name));
        field->setAccessibleName(label);
        row->addWidget(new QLabel(label, this));
        row->addWidget(field, stretch);
    };
    where_ = new QComboBox(this);
    where_->addItem(tr("this computer"), int(StudyPlace::Where::here));
    where_->addItem(tr("a Slurm cluster"), int(StudyPlace::Where::slurm));
    where_->addItem(tr("another computer, by SSH"), int(StudyPlace::Where::ssh));
    where_->setToolTip(tr("Where candidates are planned and verified; a cluster and other computers see the "
                          "folder under the same name, and have the same program in the same place"));
    where_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    where_->setMinimumContentsLength(14);
    host_ = new QLineEdit(this);
    host_->setToolTip(
        tr("The other computer as ssh knows it, such as mill2 or user@mill2; it lets you in by a key"));
    host_->setPlaceholderText(QStringLiteral("–"));
    host_->setMinimumWidth(60);
    workers_ = new QSpinBox(this);
    workers_->setRange(1, max_at_once);
    workers_->setValue(processors_here());
    workers_->setToolTip(tr("Candidates that are worked on at once; what comes out does not depend on it"));
    add(tr("Work on"), where_, "study_place", 3);
    add(tr("Host"), host_, "study_host", 2);
    add(tr("At once"), workers_, "study_workers", 1);
    connect(where_, &QComboBox::activated, this, [this](int) {
        tell_host();
        if (host_->isEnabled()) host_->setFocus();
        emit changed();
    });
    connect(where_, &QComboBox::currentIndexChanged, this, &StudyPlaceForm::tell_host);
    connect(host_, &QLineEdit::textEdited, this, &StudyPlaceForm::changed);
    connect(workers_, &QSpinBox::valueChanged, this, &StudyPlaceForm::changed);
    tell_host();
}

void StudyPlaceForm::tell_host() {
    host_->setEnabled(place().where == StudyPlace::Where::ssh);
}

StudyPlace StudyPlaceForm::place() const {
    return {.where = StudyPlace::Where(where_->currentData().toInt()),
            .host = utf8(host_->text().trimmed()),
            .workers = std::size_t(workers_->value())};
}

QString StudyPlaceForm::problem() const {
    const StudyPlace chosen = place();
    if (chosen.where == StudyPlace::Where::ssh && chosen.host.empty())
        return tr("Name the host that is to work, as ssh knows it.");
    return {};
}

} // namespace facetmill::ui
