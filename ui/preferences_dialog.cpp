#include "ui/preferences_dialog.h"

#include "ui/language.h"
#include "ui/own_folders.h"
#include "ui/text.h"
#include "ui/theme.h"
#include "ui/usual_project_box.h"

#include <QComboBox>
#include <QDesktopServices>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QUrl>
#include <QVBoxLayout>

#include <algorithm>

namespace facetmill::ui {

QStringList navigation_words(NavigationStyle style) {
    using D = PreferencesDialog;
    switch (style) {
    case NavigationStyle::facetmill:
        return {D::tr("Turn: left button"), D::tr("Move: middle, or Shift + left"),
                D::tr("Zoom: wheel, or right button")};
    case NavigationStyle::fusion:
        return {D::tr("Turn: Shift + middle button"), D::tr("Move: middle button"),
                D::tr("Zoom: wheel, or Ctrl + middle")};
    case NavigationStyle::freecad:
        return {D::tr("Turn: middle and left button, or Shift + right"),
                D::tr("Move: middle button, or Ctrl + right"), D::tr("Zoom: wheel")};
    case NavigationStyle::blender:
        return {D::tr("Turn: middle button"), D::tr("Move: Shift + middle"),
                D::tr("Zoom: wheel, or Ctrl + middle")};
    case NavigationStyle::solidworks:
        return {D::tr("Turn: middle button"), D::tr("Move: Ctrl + middle"),
                D::tr("Zoom: wheel, or Shift + middle")};
    }
    return {};
}

PreferencesDialog::PreferencesDialog(QWidget* parent) : QDialog(parent) {
    setObjectName(QStringLiteral("preferences"));
    setWindowTitle(tr("Preferences"));
    auto* column = new QVBoxLayout(this);
    column->addWidget(make_view());
    column->addWidget(make_new_projects());
    column->addWidget(make_work());
    column->addStretch(1);
    buttons_box_ = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    connect(buttons_box_, &QDialogButtonBox::accepted, this, &PreferencesDialog::accept);
    connect(buttons_box_, &QDialogButtonBox::rejected, this, &QDialog::reject);
    column->addWidget(buttons_box_);
    resize(440, sizeHint().height());
}

QGroupBox* PreferencesDialog::make_view() {
    auto* group = new QGroupBox(tr("View"), this);
    auto* form = new QFormLayout(group);
    const Navigation now = settings::navigation();
    style_ = new QComboBox(group);
    style_->setObjectName(QStringLiteral("navigation_style"));
    style_->addItems({tr("Facetmill"), tr("Fusion"), tr("FreeCAD"), tr("Blender"), tr("SolidWorks")});
    style_->setCurrentIndex(int(now.style));
    form->addRow(tr("Mo&use like"), style_);
    buttons_ = new QLabel(group);
    buttons_->setForegroundRole(QPalette::PlaceholderText);
    form->addRow(QString(), buttons_);
    const auto show = [this] {
        buttons_->setText(navigation_words(NavigationStyle(style_->currentIndex())).join(QChar('\n')));
    };
    connect(style_, &QComboBox::currentIndexChanged, this, show);
    show();
    orbit_ = new QComboBox(group);
    orbit_->setObjectName(QStringLiteral("orbit"));
    orbit_->addItems({tr("keeps Z upright"), tr("rolls freely")});
    orbit_->setCurrentIndex(int(now.orbit));
    form->addRow(tr("&Turning"), orbit_);
    colors_ = new QComboBox(group);
    colors_->setObjectName(QStringLiteral("colours"));
    colors_->addItems({tr("as the desktop"), tr("light"), tr("dark")});
    colors_->setCurrentIndex(int(settings::theme()));
    form->addRow(tr("C&olours"), colors_);
    add_language(*form);
    return group;
}

void PreferencesDialog::add_language(QFormLayout& form) {
    language_ = new QComboBox(this);
    language_->setObjectName(QStringLiteral("language"));
    language_->addItem(tr("as the system"), QString());
    for (const Language& one : languages())
        language_->addItem(QString::fromUtf8(one.name), QString::fromLatin1(one.code));
    language_->setCurrentIndex(std::max(0, language_->findData(settings::language())));
    language_->setToolTip(
        tr("Texts and numbers of the window; programs and files are the same in all of them"));
    form.addRow(tr("&Language"), language_);
    auto* later = new QLabel(tr("The window speaks it after the next start."), this);
    later->setWordWrap(true);
    later->setForegroundRole(QPalette::PlaceholderText);
    later->hide();
    form.addRow(later);
    connect(language_, &QComboBox::currentIndexChanged, later, [this, later] {
        later->setVisible(language_->currentData().toString() != settings::language());
    });
}

QGroupBox* PreferencesDialog::make_new_projects() {
    auto* group = new QGroupBox(tr("New projects"), this);
    auto* column = new QVBoxLayout(group);
    usual_ = new UsualProjectBox(group);
    usual_->set_usual(settings::usual_project());
    column->addWidget(usual_);
    return group;
}

QGroupBox* PreferencesDialog::make_work() {
    auto* group = new QGroupBox(tr("Work"), this);
    auto* form = new QFormLayout(group);
    autosave_ = new QSpinBox(group);
    autosave_->setObjectName(QStringLiteral("autosave"));
    autosave_->setRange(int(settings::shortest_autosave.count()), int(settings::longest_autosave.count()));
    autosave_->setSuffix(tr(" s"));
    autosave_->setValue(int(settings::autosave_interval().count()));
    form->addRow(tr("&Keep unsaved work every"), autosave_);
    threads_ = new QSpinBox(group);
    threads_->setObjectName(QStringLiteral("threads"));
    threads_->setRange(0, settings::max_threads);
    threads_->setSpecialValueText(tr("all"));
    threads_->setValue(settings::threads());
    form->addRow(tr("T&hreads"), threads_);
    add_folder(*form);
    return group;
}

void PreferencesDialog::add_folder(QFormLayout& form) {
    folder_ = new QLineEdit(settings::own_folder(), this);
    folder_->setObjectName(QStringLiteral("own_folder"));
    folder_->setPlaceholderText(path_text(usual_own_folder()));
    folder_->setToolTip(tr("Tools and templates are kept here; those of another folder stay there. Empty: %1")
                            .arg(path_text(usual_own_folder())));
    form.addRow(tr("L&ibraries and templates in"), folder_);
    auto* row = new QHBoxLayout;
    const auto add = [&](const QString& label, const char* name) {
        auto* button = new QPushButton(label, this);
        button->setObjectName(QLatin1String(name));
        button->setAutoDefault(false);
        row->addWidget(button);
        return button;
    };
    auto* browse = add(tr("&Browse…"), "browse_folder");
    connect(browse, &QPushButton::clicked, this, [this] {
        const QString found =
            QFileDialog::getExistingDirectory(this, tr("Keep libraries and templates in"), shown_folder());
        if (!found.isEmpty()) folder_->setText(QDir::toNativeSeparators(found));
    });
    auto* show = add(tr("Show"), "show_folder");
    connect(show, &QPushButton::clicked, this, [this] {
        QDir().mkpath(shown_folder());
        QDesktopServices::openUrl(QUrl::fromLocalFile(shown_folder()));
    });
    row->addStretch(1);
    form.addRow(QString(), row);
    trouble_ = new QLabel(this);
    trouble_->setObjectName(QStringLiteral("folder_trouble"));
    trouble_->setWordWrap(true);
    QPalette alarm = trouble_->palette();
    alarm.setColor(QPalette::WindowText, signal_colors(palette()).bad);
    trouble_->setPalette(alarm);
    trouble_->hide();
    form.addRow(trouble_);
    connect(folder_, &QLineEdit::textChanged, this, &PreferencesDialog::judge_folder);
}

QString PreferencesDialog::shown_folder() const {
    const QString typed = QDir::fromNativeSeparators(folder_->text().trimmed());
    return typed.isEmpty() ? path_text(usual_own_folder()) : QDir::cleanPath(typed);
}

/// A folder that is not there yet is made when something is kept.
void PreferencesDialog::judge_folder() {
    const QFileInfo info(shown_folder());
    const QString trouble = info.isRelative()                ? tr("Write the whole path of a folder.")
                            : info.exists() && !info.isDir() ? tr("This is a file: choose a folder.")
                            : info.exists() && !info.isWritable()
                                ? tr("Nothing can be written into this folder: choose another one.")
                                : QString();
    trouble_->setText(trouble);
    trouble_->setVisible(!trouble.isEmpty());
    buttons_box_->button(QDialogButtonBox::Ok)->setEnabled(trouble.isEmpty());
}

void PreferencesDialog::accept() {
    settings::set_navigation({NavigationStyle(style_->currentIndex()), Orbit(orbit_->currentIndex())});
    settings::set_theme(Theme(colors_->currentIndex()));
    settings::set_language(language_->currentData().toString());
    settings::set_usual_project(usual_->usual());
    settings::set_autosave_interval(std::chrono::seconds(autosave_->value()));
    settings::set_threads(threads_->value());
    settings::set_own_folder(folder_->text().trimmed().isEmpty() ? QString() : shown_folder());
    QDialog::accept();
}

} // namespace facetmill::ui
