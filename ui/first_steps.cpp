#include "ui/first_steps.h"

#include "ui/all_setups.h"
#include "ui/controllers.h"
#include "ui/flow_layout.h"
#include "ui/icons.h"
#include "ui/main_window.h"
#include "ui/program_export.h"
#include "ui/project_tree.h"
#include "ui/settings.h"
#include "ui/verification_controller.h"

#include <QAction>
#include <QBoxLayout>
#include <QEvent>
#include <QLabel>
#include <QToolButton>

#include <algorithm>

namespace facetmill::ui {

namespace {

struct StepWords {
    const char* name; ///< of the button
    QString label, how;
};

std::array<StepWords, FirstSteps::step_count> step_words() {
    using F = FirstSteps;
    return {
        {{"step_open", F::tr("Open"),
          F::tr("Open a mesh, drop one here, or take a sample. STL files carry no unit: the sizes tell.")},
         {"step_place", F::tr("Lay down, zero"),
          F::tr("Lay the part on a face of the list, then put the zero on the stock: press P.")},
         {"step_operations", F::tr("Operations"),
          F::tr("Choose the tool and its values in the form; + adds Rough before Finish.")},
         {"step_judge", F::tr("Plan and verify"),
          F::tr("F5 plans, F6 verifies. Look at what the list finds before you go on.")},
         {"step_write", F::tr("Export"),
          F::tr("Choose the control in Machine; Ctrl+E writes one program an operation.")}}};
}

} // namespace

FirstSteps::FirstSteps(MainWindow& window) : QFrame(window.centralWidget()), window_(window) {
    setObjectName(QStringLiteral("first_steps"));
    setFrameShape(QFrame::NoFrame);
    auto* row = new QHBoxLayout;
    auto* steps = new QWidget(this);
    auto* flow = new FlowLayout(steps, 2);
    const auto words = step_words();
    for (std::size_t i = 0; i < step_count; ++i) {
        auto* button = new QToolButton(steps);
        button->setObjectName(QLatin1String(words[i].name));
        button->setText(tr("%1 %2").arg(i + 1).arg(words[i].label));
        button->setToolTip(words[i].how);
        button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        button->setAutoRaise(true);
        button->setFocusPolicy(Qt::StrongFocus);
        connect(button, &QToolButton::clicked, this, [this, i] { take(Step(i)); });
        buttons_[i] = button;
        flow->addWidget(button);
    }
    auto* close = new QToolButton(this);
    close->setObjectName(QStringLiteral("end_first_steps"));
    close->setIcon(icon(Icon::close));
    close->setAutoRaise(true);
    close->setFocusPolicy(Qt::StrongFocus);
    close->setAccessibleName(tr("Put the steps away"));
    close->setToolTip(tr("Put the steps away; Help shows them again"));
    connect(close, &QToolButton::clicked, this, [this] {
        hide();
        window_.update_commands(); // the menu says whether they are there
    });
    row->addWidget(steps, 1);
    row->addWidget(close, 0, Qt::AlignTop);
    how_ = new QLabel(this);
    how_->setObjectName(QStringLiteral("step_how"));
    how_->setWordWrap(true);
    how_->setForegroundRole(QPalette::PlaceholderText);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(6, 3, 6, 4);
    column->setSpacing(1);
    column->addLayout(row);
    column->addWidget(how_);
    if (auto* center = qobject_cast<QBoxLayout*>(window.centralWidget()->layout()))
        center->insertWidget(0, this);
    hide();

    connect(&window.document(), &Document::opened, this, &FirstSteps::reset);
    connect(&window.document(), &Document::changed, this, &FirstSteps::look);
    connect(&window.controllers(), &Controllers::verified, this, [this] {
        // What failed is looked at first.
        if (window_.verification().model().verdict() == Verdict::verified)
            taken_[std::size_t(Step::judge)] = true;
        show_steps();
    });
    connect(&window.exports(), &ProgramExport::programs_written, this, [this] {
        taken_[std::size_t(Step::write)] = true;
        show_steps();
    });
}

void FirstSteps::start() {
    reset();
    show();
    buttons_[std::min(next(), step_count - 1)]->setFocus();
}

void FirstSteps::reset() {
    taken_ = {};
    const Project& project = window_.document().project();
    taken_[std::size_t(Step::open)] = window_.document().has_part();
    place_before_ = place_of(project);
    operations_before_ = operations_of(project);
    show_steps();
}

std::string FirstSteps::place_of(const Project& project) {
    std::string text;
    const auto add = [&](double number) { text += std::to_string(number) + ' '; };
    for (std::size_t k = 0; k < 3; ++k) {
        add(project.part.rotate[k]);
        add(project.part.translate[k]);
        add(project.programs.zero_place[k]);
        add(project.programs.zero[k]);
    }
    return text + std::to_string(int(project.part.mirror)) + std::to_string(int(project.programs.zero_from));
}

std::string FirstSteps::operations_of(const Project& project) {
    std::string text;
    for (const auto& operation : project.operations) {
        text += std::string(operation->kind()) + ' ';
        for (const ParameterInfo* p : operation->parameters())
            text += p->key + '=' + p->value_text(operation->get(p->key), LengthUnit::mm) + ' ';
    }
    for (const Tool& tool : project.tools)
        text += std::to_string(tool.number) + ' ' + std::to_string(tool.diameter) + ' ';
    return text;
}

void FirstSteps::look() {
    if (isHidden()) return;
    const Project& project = window_.document().project();
    if (place_of(project) != place_before_) taken_[std::size_t(Step::place)] = true;
    if (operations_of(project) != operations_before_) taken_[std::size_t(Step::operations)] = true;
    show_steps();
}

bool FirstSteps::done(Step step) const {
    return std::any_of(taken_.begin() + std::ptrdiff_t(step), taken_.end(), [](bool taken) { return taken; });
}

std::size_t FirstSteps::next() const {
    std::size_t i = 0;
    while (i < step_count && done(Step(i)))
        ++i;
    return i;
}

void FirstSteps::show_steps() {
    const auto words = step_words();
    const std::size_t now = next();
    for (std::size_t i = 0; i < step_count; ++i) {
        QFont font = buttons_[i]->font();
        font.setBold(i == now);
        buttons_[i]->setFont(font);
        buttons_[i]->setIcon(icon(i < now ? Icon::verified : Icon::not_planned));
        buttons_[i]->setAccessibleDescription(i < now ? tr("Done") : i == now ? tr("Next") : QString());
    }
    how_->setText(now < step_count ? words[now].how : tr("Done: that was a whole job. F1 tells more."));
}

void FirstSteps::take(Step step) {
    const auto trigger = [this](const char* name) {
        if (auto* action = window_.findChild<QAction*>(QLatin1String(name)); action && action->isEnabled())
            action->trigger();
    };
    Document& document = window_.document();
    switch (step) {
    case Step::open:
        return trigger("open");
    case Step::place:
        return trigger("place");
    case Step::operations:
        if (document.operation_count() > 0) {
            window_.tree().select({TreeNode::Kind::operation, 0});
            emit window_.tree().edit_parameters();
        }
        return;
    case Step::judge:
        return trigger(document.all_planned() ? "verify" : "plan");
    case Step::write:
        return trigger("export");
    }
}

void FirstSteps::changeEvent(QEvent* event) {
    QFrame::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && buttons_.back()) show_steps();
}

} // namespace facetmill::ui
