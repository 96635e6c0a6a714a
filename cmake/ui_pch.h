// Precompiled for the widgets and for the tests of windows.
#pragma once
#include "cmake/core_pch.h"
#include <QtWidgets/QtWidgets>
