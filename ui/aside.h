// Small work that the window does not wait for, in one thread aside from its own: what a disk or the freeing
// of a large thing would hold up there.
#pragma once

#include <chrono>
#include <functional>
#include <memory>

namespace facetmill::ui {

/// Work is done in the order in which it was handed over. It must not throw, nor touch what belongs to the
/// window's thread. What is left when the application ends is done before it has ended.
void do_aside(std::function<void()> work);

/// Returns when all is done that was handed over before.
void finish_aside();
/// The same, but waits no longer than so: false when something is left to do.
bool finish_aside(std::chrono::milliseconds at_most);

/// Gives a large thing up where freeing it holds up nobody: a little later, when others that have it too,
/// such as what is shown of it, have let go of it.
void let_go(std::shared_ptr<const void> thing);

} // namespace facetmill::ui
