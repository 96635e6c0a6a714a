// Progress of OpenCASCADE's algorithms as lines on the standard output.
#pragma once

#include <Message_ProgressIndicator.hxx>
#include <Message_ProgressRange.hxx>

#include <chrono>
#include <string>

namespace facetmill::step {

class StepProgress {
public:
    /// `descriptor`: where the lines go.
    explicit StepProgress(int descriptor) : descriptor_(descriptor) {}

    /// A new stretch of the whole, from 0 to 1, and what is at work in it; the range is for one algorithm.
    Message_ProgressRange stretch(double from, double to, const std::string& label);
    /// Share of the present stretch that is done.
    void set(double share);
    /// A line as it is.
    void line(const std::string& text) const;

private:
    class Indicator;
    int descriptor_;
    double from_ = 0, to_ = 0, told_ = -1;
    std::string label_;
    opencascade::handle<Message_ProgressIndicator> indicator_;
    std::chrono::steady_clock::time_point last_{};
};

} // namespace facetmill::step
