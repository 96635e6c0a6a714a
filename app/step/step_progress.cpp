#include "app/step/step_progress.h"

#include <Message_ProgressScope.hxx>

#include <unistd.h>

namespace facetmill::step {

/// Hands on how far an algorithm is.
class StepProgress::Indicator : public Message_ProgressIndicator {
public:
    explicit Indicator(StepProgress& owner) : owner_(owner) {}

private:
    void Show(const Message_ProgressScope&, const Standard_Boolean) override { owner_.set(GetPosition()); }
    StepProgress& owner_;
};

Message_ProgressRange StepProgress::stretch(double from, double to, const std::string& label) {
    from_ = from;
    to_ = to;
    label_ = label;
    told_ = -1;
    indicator_ = new Indicator(*this);
    set(0);
    return indicator_->Start();
}

void StepProgress::set(double share) {
    const auto now = std::chrono::steady_clock::now();
    // Lines also say that the program is alive: one in a while even where nothing moves.
    if (told_ >= 0 && share < told_ + 0.01 && now - last_ < std::chrono::seconds(1)) return;
    told_ = share;
    last_ = now;
    line("progress " + std::to_string(from_ + (to_ - from_) * share) + " " + label_);
}

void StepProgress::line(const std::string& text) const {
    const std::string whole = text + "\n";
    for (std::size_t at = 0; at < whole.size();) {
        const ssize_t n = ::write(descriptor_, whole.data() + at, whole.size() - at);
        if (n <= 0) return; // nobody listens any more
        at += std::size_t(n);
    }
}

} // namespace facetmill::step
